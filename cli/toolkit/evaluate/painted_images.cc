// SPDX-License-Identifier: BSD-3-Clause
// "The program" is that of S. Lee, "Fisheye-Calib-Adapter", 2024; see painted_images.h.
#include "painted_images.h"

#include <fca/compare/image_similarity.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace fca {

namespace {

constexpr int kNoSource = -1;  // the source index of a pixel that no disc covers

/// Returns, for each pixel of the painted image, the index of the image pixel from which its colour comes. kNoSource: no disc
/// covers the pixel, and it is black.
std::vector<int> colour_sources(int width, int height, const Placement& place) {
  // The offsets (right, down) of a filled disc of radius 1 px.
  constexpr std::array<std::array<int, 2>, 5> kDisc = {{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  std::vector<int> source_index(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kNoSource);
  const auto inside = [](double value, int end) { return value >= 0.0 && value < end; };
  // The order is that of the program, column by column: where discs overlap, the last one is visible.
  for (int u = 0; u < width; ++u) {
    for (int v = 0; v < height; ++v) {
      const std::optional<Pixel> to = place({static_cast<double>(u), static_cast<double>(v)});
      if (!to || !inside(std::floor((*to)[0] + 0.5), width) || !inside(std::floor((*to)[1] + 0.5), height)) continue;
      // The program tests the rounded position (above), but draws at the truncated one. It takes the colour from the new
      // position, not from (u, v); so does this function.
      const int column = static_cast<int>((*to)[0]);
      const int row = static_cast<int>((*to)[1]);
      for (const auto& [right, down] : kDisc) {
        const int x = column + right;
        const int y = row + down;
        if (inside(x, width) && inside(y, height)) source_index[static_cast<std::size_t>(y * width + x)] = row * width + column;
      }
    }
  }
  return source_index;
}

/// Paints one colour plane, with 8-bit levels.
GreyImage paint(const GreyImage& image, const std::vector<int>& source_index) {
  constexpr float kFullScale = 255.0F;
  GreyImage result{image.width, image.height, kFullScale, std::vector<float>(source_index.size(), 0.0F)};
  for (std::size_t i = 0; i < source_index.size(); ++i) {
    if (source_index[i] != kNoSource)
      result.samples[i] = std::floor(image.samples[static_cast<std::size_t>(source_index[i])] * kFullScale / image.full_scale);
  }
  return result;
}

/// Returns true for each pixel whose grey level, rounded to a whole number, is not 0.
std::vector<bool> not_black(const std::vector<GreyImage>& colours) {
  constexpr std::array<double, 3> kGreyWeights = {0.114, 0.587, 0.299};  // of blue, green and red
  std::vector<bool> result;
  for (std::size_t i = 0; i < colours.front().samples.size(); ++i) {
    double grey = 0.0;
    for (std::size_t c = 0; c < colours.size(); ++c)
      grey += (colours.size() == kGreyWeights.size() ? kGreyWeights.at(c) : 1.0) * static_cast<double>(colours[c].samples[i]);
    result.push_back(std::lround(grey) != 0);
  }
  return result;
}

/// Blurs an image with a Gaussian of 11 x 11 px and standard deviation 1.5 px. Beyond the border the image is mirrored about
/// its last pixel.
class Blur {
 public:
  Blur(int width, int height) : width_(width), height_(height) {
    constexpr double kDeviation = 1.5;
    double sum = 0.0;
    for (int i = -kHalfWidth; i <= kHalfWidth; ++i)
      sum += weights_.at(static_cast<std::size_t>(i + kHalfWidth)) = std::exp(-0.5 * i * i / (kDeviation * kDeviation));
    for (double& weight : weights_) weight /= sum;
  }

  [[nodiscard]] std::vector<double> operator()(const std::vector<double>& image) const {
    return along(along(image, 1, 0), 0, 1);
  }

 private:
  static constexpr int kHalfWidth = 5;

  /// The index of the mirrored pixel if `i` is beyond the border, otherwise `i`.
  static int mirrored(int i, int count) { return i < 0 ? -i : i >= count ? 2 * (count - 1) - i : i; }

  /// Blurs in one direction: (1, 0) along rows or (0, 1) along columns.
  [[nodiscard]] std::vector<double> along(const std::vector<double>& image, int right, int down) const {
    std::vector<double> result(image.size());
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        double sum = 0.0;
        for (int i = -kHalfWidth; i <= kHalfWidth; ++i) {
          const int from = mirrored(y + i * down, height_) * width_ + mirrored(x + i * right, width_);
          sum += weights_.at(static_cast<std::size_t>(i + kHalfWidth)) * image[static_cast<std::size_t>(from)];
        }
        result[static_cast<std::size_t>(y * width_ + x)] = sum;
      }
    }
    return result;
  }

  int width_;
  int height_;
  std::array<double, 2 * kHalfWidth + 1> weights_{};
};

std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] * b[i];
  return result;
}

/// The mean SSIM of two 8-bit planes over all their pixels. A pixel that is black in one plane is set to black in both.
double mean_ssim(const GreyImage& one, const GreyImage& other) {
  constexpr double kC1 = 6.5025;   // (0.01 * 255)^2
  constexpr double kC2 = 58.5225;  // (0.03 * 255)^2
  std::vector<double> a(one.samples.size(), 0.0);
  std::vector<double> b = a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (one.samples[i] == 0.0F || other.samples[i] == 0.0F) continue;
    a[i] = static_cast<double>(one.samples[i]);
    b[i] = static_cast<double>(other.samples[i]);
  }
  const Blur blur(one.width, one.height);
  const std::vector<double> mean_a = blur(a);
  const std::vector<double> mean_b = blur(b);
  const std::vector<double> square_a = blur(product(a, a));
  const std::vector<double> square_b = blur(product(b, b));
  const std::vector<double> mixed = blur(product(a, b));
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double of_means = mean_a[i] * mean_b[i];
    const double squares = mean_a[i] * mean_a[i] + mean_b[i] * mean_b[i];
    sum += (2.0 * of_means + kC1) * (2.0 * (mixed[i] - of_means) + kC2) /
           ((squares + kC1) * (square_a[i] + square_b[i] - squares + kC2));
  }
  return sum / static_cast<double>(a.size());
}

/// The PSNR [dB] of the first colour plane over the pixels that are black in neither image. 0 if the planes are equal, as in
/// the program.
double psnr(const std::vector<GreyImage>& one, const std::vector<GreyImage>& other) {
  const std::vector<bool> not_black_in_one = not_black(one);
  const std::vector<bool> not_black_in_other = not_black(other);
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < not_black_in_one.size(); ++i) {
    if (!not_black_in_one[i] || !not_black_in_other[i]) continue;
    const double difference = static_cast<double>(one.front().samples[i]) - static_cast<double>(other.front().samples[i]);
    squares += difference * difference;
    count += 1.0;
  }
  constexpr double kNegligibleSum = 1e-10;  // a sum of squared differences that the program takes for 0
  return squares <= kNegligibleSum ? 0.0 : psnr_db(squares / count, static_cast<double>(one.front().full_scale));
}

/// Paints all colour planes of an image.
std::vector<GreyImage> paint_all(const std::vector<GreyImage>& colours, const Placement& place) {
  const std::vector<int> source_index = colour_sources(colours.front().width, colours.front().height, place);
  std::vector<GreyImage> result;
  result.reserve(colours.size());
  for (const GreyImage& colour : colours) result.push_back(paint(colour, source_index));
  return result;
}

}  // namespace

PaintedImage painted_image(const std::vector<GreyImage>& colours, const Placement& place) {
  const std::vector<GreyImage> painted_in_place = paint_all(colours, [](const Pixel& pixel) { return pixel; });
  const std::vector<GreyImage> painted_at_place = paint_all(colours, place);
  return {psnr(painted_in_place, painted_at_place), mean_ssim(painted_in_place.front(), painted_at_place.front())};
}

PaintedImage painted_with_noise(const std::vector<GreyImage>& colours) {
  constexpr double kNoise = 1e-9;  // px
  std::minstd_rand random(1);      // a fixed seed: every run gives the same numbers
  const auto noise = [&random] { return kNoise * (2.0 * static_cast<double>(random()) / std::minstd_rand::max() - 1.0); };
  return painted_image(colours, [&noise](const Pixel& pixel) {
    const double right = noise();
    return Pixel{pixel[0] + right, pixel[1] + noise()};
  });
}

}  // namespace fca
