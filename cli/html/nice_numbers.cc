// SPDX-License-Identifier: BSD-3-Clause
#include "nice_numbers.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace fca::cli {

namespace {

constexpr std::array kSteps = {1.0, 2.0, 5.0, 10.0};
/// How far rounding may move a round number.
constexpr double kSlack = 1e-9;

double power_below(double value) { return std::pow(10.0, std::floor(std::log10(value) + kSlack)); }

std::string superscript(int number) {
  constexpr std::array<std::string_view, 10> kDigits = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                        "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = number < 0 ? "\u207b" : "";
  for (const char digit : std::to_string(std::abs(number))) text += kDigits.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

}  // namespace

double nice_above(double value) {
  const double power = power_below(value);
  for (const double step : kSteps) {
    if (step * power >= value * (1.0 - kSlack)) return step * power;
  }
  return 10.0 * power;
}

double nice_below(double value) {
  const double power = power_below(value);
  double best = power;
  for (const double step : kSteps) {
    if (step * power <= value * (1.0 + kSlack)) best = step * power;
  }
  return best;
}

std::vector<double> linear_ticks(double from, double to, int count) {
  std::vector<double> ticks;
  if (!(to > from)) return ticks;
  const double step = nice_above((to - from) / count);
  const double slack = kSlack * (to - from);
  for (double k = std::ceil((from - slack) / step); k * step <= to + slack; k += 1.0) ticks.push_back(k * step);
  return ticks;
}

std::vector<double> decades(double from, double to, int most) {
  std::vector<double> ticks;
  const int first = static_cast<int>(std::ceil(std::log10(from) - kSlack));
  const int last = static_cast<int>(std::floor(std::log10(to) + kSlack));
  const int step = std::max(1, (last - first + most) / most);
  for (int exponent = last; exponent >= first; exponent -= step) ticks.push_back(std::pow(10.0, exponent));
  std::ranges::reverse(ticks);
  return ticks;
}

std::string tick_label(double value) {
  constexpr double kSmallest = 1e-3;
  constexpr double kLargest = 1e5;
  const double size = std::abs(value);
  if (size == 0.0) return "0";
  if (size >= kSmallest * (1.0 - kSlack) && size < kLargest) return text::format_short(value, 6);
  const int exponent = static_cast<int>(std::floor(std::log10(size) + kSlack));
  const double factor = value / std::pow(10.0, exponent);
  const std::string power = "10" + superscript(exponent);
  return std::abs(factor - 1.0) < kSlack ? power : text::format_short(factor, 3) + "\u00b7" + power;
}

}  // namespace fca::cli
