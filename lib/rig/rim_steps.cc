// SPDX-License-Identifier: BSD-3-Clause
#include "rim_steps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <span>

namespace fca::internal {

namespace {

float nth(std::vector<float> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

/// The bits of a number such that they are in the order of numbers.
std::uint32_t in_order(float value) {
  constexpr std::uint32_t kSign = 0x8000'0000;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const bool is_negative = (bits & kSign) != 0;
  return bits ^ (kSign | (0U - static_cast<std::uint32_t>(is_negative)));
}

/// The value below which that share of the values lies. In two steps, of which the second sees next to none of them: sorting as
/// far as that value would move all.
float percentile(std::span<const float> values, double share) {
  constexpr int kBits = 16;
  if (values.size() < std::size_t{1} << kBits) return nth(std::vector(values.begin(), values.end()), share);
  std::vector<std::size_t> bins(std::size_t{1} << kBits);
  for (const float value : values) ++bins[in_order(value) >> kBits];
  auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::size_t bin = 0;
  for (; at >= bins[bin]; ++bin) at -= bins[bin];
  std::vector<float> same;
  same.reserve(bins[bin]);
  std::ranges::copy_if(values, std::back_inserter(same), [bin](float value) { return in_order(value) >> kBits == bin; });
  const auto place = same.begin() + static_cast<std::ptrdiff_t>(at);
  std::ranges::nth_element(same, place);
  return *place;
}

/// Where on the way in, from the first lit sample on, half the light is reached that falls a little further in: blur leaves
/// that where it is.
template <class Place>
double half_lit(const GreyView& view, const Levels& levels, const Place& place, double first) {
  constexpr double kFurtherIn = 8.0;  // px
  const double end = std::max(first - kFurtherIn, 0.0);
  const double half = 0.5 * (levels.black + view.value(place(end)));
  double outer = view.value(place(first + 1.0));
  for (double t = first; t >= end; t -= 1.0) {
    const double inner = view.value(place(t));
    if (inner > half && outer <= half) return t + (inner - half) / (inner - outer);
    outer = inner;
  }
  return first + 0.5;
}

/// Means of 2 `half_width` + 1 samples along a row of `count`; fewer at its ends.
void smooth_row(const float* from, float* to, int count, int half_width) {
  double sum = 0.0;
  int samples = 0;
  for (int i = -half_width; i < count; ++i) {
    if (i + half_width < count) {
      sum += from[i + half_width];
      ++samples;
    }
    if (i - half_width > 0) {
      sum -= from[i - half_width - 1];
      --samples;
    }
    if (i >= 0) to[i] = static_cast<float>(sum / samples);
  }
}

/// The same along all columns, row by row: what lies in memory one after the other is read so.
void smooth_columns(const float* from, float* to, int width, int height, int half_width) {
  const auto columns = static_cast<std::size_t>(width);
  std::vector<double> sums(columns);
  const auto row_of = [&](int row) { return static_cast<std::size_t>(row) * columns; };
  int samples = 0;
  for (int row = -half_width; row < height; ++row) {
    if (row + half_width < height) {
      const float* const next = from + row_of(row + half_width);
      for (std::size_t i = 0; i < columns; ++i) sums[i] += next[i];
      ++samples;
    }
    if (row - half_width > 0) {
      const float* const last = from + row_of(row - half_width - 1);
      for (std::size_t i = 0; i < columns; ++i) sums[i] -= last[i];
      --samples;
    }
    if (row < 0) continue;
    float* const means = to + row_of(row);
    const double count = samples;
    for (std::size_t i = 0; i < columns; ++i) means[i] = static_cast<float>(sums[i] / count);
  }
}

}  // namespace

GreyImage smoothed(const GreyImage& image) {
  constexpr int kSmall = 200;  // px
  const int half_width = std::min(image.width, image.height) < kSmall ? 1 : 2;
  GreyImage along_rows = image;
  for (std::ptrdiff_t row = 0; row < image.height; ++row) {
    const std::ptrdiff_t first = row * image.width;
    smooth_row(image.samples.data() + first, along_rows.samples.data() + first, image.width, half_width);
  }
  GreyImage result = along_rows;
  smooth_columns(along_rows.samples.data(), result.samples.data(), image.width, image.height, half_width);
  return result;
}

std::optional<Levels> levels_of(const GreyView& view, double bright_share) {
  const GreyImage& image = view.image();
  const int side = std::max(3, std::min(image.width, image.height) / 24);
  std::optional<float> black;
  float noise = 0.0F;
  for (const int left : {0, image.width - side}) {
    for (const int top : {0, image.height - side}) {
      std::vector<float> corner;
      for (int row = top; row < top + side; ++row) {
        for (int column = left; column < left + side; ++column) corner.push_back(view.at(column, row));
      }
      const float median = percentile(corner, 0.5);
      if (black && median >= *black) continue;
      black = median;
      for (float& value : corner) value = std::abs(value - median);
      noise = 1.4826F * percentile(corner, 0.5);
    }
  }
  const float bright = percentile(image.samples, 1.0 - bright_share);
  constexpr float kTooDark = 0.02F;  // of the full scale: nothing can be told from the noise of a sensor
  if (!(bright - *black > kTooDark * image.full_scale)) return std::nullopt;
  constexpr float kNoises = 6.0F;
  constexpr float kShare = 0.06F;  // of the bright: where a vignette ends
  constexpr float kSteps = 2.5F / 255.0F;
  const float threshold = *black + std::max({kNoises * noise, kShare * (bright - *black), kSteps * image.full_scale});
  if (!(threshold < bright)) return std::nullopt;
  return Levels{*black, bright, threshold};
}

std::vector<Steps> steps_from_dark(const GreyView& view, const Levels& levels, const Pixel& centre) {
  constexpr std::size_t kMost = 3;  // flare, its ghost, and the rim
  constexpr int kRun = 3;           // px: shorter ones are single hot or dead pixels
  std::vector<Steps> all(kDirections);
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kDirections;
    const Pixel way = {std::cos(angle), std::sin(angle)};
    const auto place = [&](double t) { return Pixel{centre[0] + t * way[0], centre[1] + t * way[1]}; };
    double end = 0.0;
    while (view.inside(place(end + 1.0))) end += 1.0;
    int dark = 0;
    int lit = 0;
    bool was_dark = false;
    for (double t = end; t >= 0.0 && all[static_cast<std::size_t>(k)].size() < kMost; t -= 1.0) {
      const bool is_lit = view.value(place(t)) > levels.threshold;
      dark = is_lit ? 0 : dark + 1;
      lit = is_lit ? lit + 1 : 0;
      if (dark >= kRun) was_dark = true;
      if (lit < kRun || !was_dark) continue;
      was_dark = false;
      all[static_cast<std::size_t>(k)].push_back(place(half_lit(view, levels, place, t + lit - 1.0)));
    }
  }
  return all;
}

}  // namespace fca::internal
