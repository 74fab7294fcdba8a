// SPDX-License-Identifier: BSD-3-Clause
#include <fca/compare/image_similarity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace fca {

namespace {

constexpr int kRadius = 5;
constexpr std::size_t kSide = 2 * kRadius + 1;

/// One side's weights of the window, which is their product along rows and columns.
std::array<double, kSide> gaussian() {
  constexpr double kDeviation = 1.5;
  std::array<double, kSide> weights{};
  double sum = 0.0;
  for (std::size_t i = 0; i < kSide; ++i) {
    const double x = (static_cast<double>(i) - kRadius) / kDeviation;
    weights.at(i) = std::exp(-0.5 * x * x);
    sum += weights.at(i);
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// A field over the image; its weighted means are of the pixels whose window lies inside.
class Field {
 public:
  template <class Value>
  Field(const GreyImage& image, const Value& value) : width_(image.width), height_(image.height) {
    values_.reserve(image.samples.size());
    for (std::size_t i = 0; i < image.samples.size(); ++i) values_.push_back(value(i));
  }

  /// Means over the window about each pixel, first along the rows, then along the columns. Left as they are at the borders.
  [[nodiscard]] std::vector<double> means() const {
    const std::array<double, kSide> weights = gaussian();
    std::vector<double> along_rows = values_;
    for (int v = 0; v < height_; ++v) {
      for (int u = kRadius; u < width_ - kRadius; ++u)
        along_rows[index(u, v)] = mean(values_, weights, index(u - kRadius, v), 1);
    }
    std::vector<double> result = along_rows;
    for (int v = kRadius; v < height_ - kRadius; ++v) {
      for (int u = kRadius; u < width_ - kRadius; ++u)
        result[index(u, v)] = mean(along_rows, weights, index(u, v - kRadius), static_cast<std::size_t>(width_));
    }
    return result;
  }

 private:
  [[nodiscard]] std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(u);
  }
  static double mean(const std::vector<double>& values, const std::array<double, kSide>& weights, std::size_t first,
                     std::size_t step) {
    double sum = 0.0;
    for (std::size_t i = 0; i < kSide; ++i) sum += weights[i] * values[first + i * step];
    return sum;
  }

  int width_;
  int height_;
  std::vector<double> values_;
};

}  // namespace

ImageSimilarity similarity(const GreyImage& a, const GreyImage& b, std::span<const std::uint8_t> mask) {
  ImageSimilarity result;
  const auto in_mask = [&mask](std::size_t i) { return mask.empty() || mask[i] != 0; };
  const auto of_a = [&a](std::size_t i) { return static_cast<double>(a.samples[i]); };
  const auto of_b = [&b](std::size_t i) { return static_cast<double>(b.samples[i]); };
  std::size_t compared = 0;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    if (!in_mask(i)) continue;
    ++compared;
    result.mean_square += (of_a(i) - of_b(i)) * (of_a(i) - of_b(i));
  }
  if (compared == 0) return result;
  const auto pixels = static_cast<double>(a.samples.size());
  result.mean_square /= static_cast<double>(compared);
  result.compared = static_cast<double>(compared) / pixels;

  const std::vector<double> mean_a = Field(a, of_a).means();
  const std::vector<double> mean_b = Field(a, of_b).means();
  const std::vector<double> mean_aa = Field(a, [&](std::size_t i) { return of_a(i) * of_a(i); }).means();
  const std::vector<double> mean_bb = Field(a, [&](std::size_t i) { return of_b(i) * of_b(i); }).means();
  const std::vector<double> mean_ab = Field(a, [&](std::size_t i) { return of_a(i) * of_b(i); }).means();
  // 1 where the whole window is in the mask, to rounding.
  const std::vector<double> inside = Field(a, [&](std::size_t i) { return in_mask(i) ? 1.0 : 0.0; }).means();
  constexpr double kWhole = 1.0 - 1e-9;
  const double C1 = std::pow(0.01 * a.full_scale, 2);
  const double C2 = std::pow(0.03 * a.full_scale, 2);
  double sum = 0.0;
  std::size_t windows = 0;
  for (int v = kRadius; v < a.height - kRadius; ++v) {
    for (int u = kRadius; u < a.width - kRadius; ++u) {
      const std::size_t i = static_cast<std::size_t>(v) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(u);
      if (inside[i] < kWhole) continue;
      const double product = mean_a[i] * mean_b[i];
      const double squares = mean_a[i] * mean_a[i] + mean_b[i] * mean_b[i];
      const double covariance = mean_ab[i] - product;
      const double variances = mean_aa[i] + mean_bb[i] - squares;
      sum += (2.0 * product + C1) * (2.0 * covariance + C2) / ((squares + C1) * (variances + C2));
      ++windows;
    }
  }
  if (windows > 0) result.ssim = sum / static_cast<double>(windows);
  result.windows = static_cast<double>(windows) / pixels;
  return result;
}

double psnr_db(double mean_square, double full_scale) {
  if (!(mean_square > 0.0)) return std::numeric_limits<double>::infinity();
  return 10.0 * std::log10(full_scale * full_scale / mean_square);
}

}  // namespace fca
