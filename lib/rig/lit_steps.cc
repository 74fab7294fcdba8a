// SPDX-License-Identifier: BSD-3-Clause
#include "lit_steps.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace fca::internal {

namespace {

float percentile(std::vector<float> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
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

/// Means of 2 `reach` + 1 samples along a line of `count` that lie `stride` apart; fewer at its ends.
void smooth_line(const float* from, float* to, int count, std::ptrdiff_t stride, int reach) {
  double sum = 0.0;
  int samples = 0;
  for (int i = -reach; i < count; ++i) {
    if (i + reach < count) {
      sum += from[(i + reach) * stride];
      ++samples;
    }
    if (i - reach > 0) {
      sum -= from[(i - reach - 1) * stride];
      --samples;
    }
    if (i >= 0) to[i * stride] = static_cast<float>(sum / samples);
  }
}

}  // namespace

GreyImage smoothed(const GreyImage& image) {
  constexpr int kSmall = 200;  // px
  const int reach = std::min(image.width, image.height) < kSmall ? 1 : 2;
  GreyImage along_rows = image;
  for (std::ptrdiff_t row = 0; row < image.height; ++row) {
    const std::ptrdiff_t first = row * image.width;
    smooth_line(image.samples.data() + first, along_rows.samples.data() + first, image.width, 1, reach);
  }
  GreyImage result = along_rows;
  for (int column = 0; column < image.width; ++column)
    smooth_line(along_rows.samples.data() + column, result.samples.data() + column, image.height, image.width, reach);
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
      noise = 1.4826F * percentile(std::move(corner), 0.5);
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
