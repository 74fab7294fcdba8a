// SPDX-License-Identifier: BSD-3-Clause
#include "colour_scale.h"

#include <algorithm>
#include <string_view>

namespace fca::cli {

Rgb viridis(double share) {
  constexpr std::size_t kLast = kViridis.size() - 1;
  const double place = (share > 0.0 ? std::min(share, 1.0) : 0.0) * static_cast<double>(kLast);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kLast - 1);
  const double part = place - static_cast<double>(below);
  Rgb colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const double value = (1.0 - part) * kViridis[below][i] + part * kViridis[below + 1][i];
    // To the nearest: no value is negative.
    colour[i] = static_cast<std::uint8_t>(static_cast<unsigned>(2.0 * value + 1.0) / 2U);
  }
  return colour;
}

std::string css_colour(const Rgb& colour) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const unsigned part : colour) {
    text += kDigits[part >> 4U];
    text += kDigits[part & 15U];
  }
  return text;
}

}  // namespace fca::cli
