// SPDX-License-Identifier: BSD-3-Clause
#include "weights.h"

#include <fca/convert/sample.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fca::internal {

namespace {

/// The weight of black pixels, as a fraction of the largest weight. An error of 30 px at a black pixel then costs as much as
/// one of 0.001 px at a white pixel.
constexpr double kWeightOfBlack = 1e-9;

double brightest(const GreyImage& image) { return *std::ranges::max_element(image.samples); }

/// The grey value at a pixel, interpolated bilinearly between the centres of its neighbours. If these have the same value, the
/// result is exactly this value.
double grey_at(const GreyImage& image, const Pixel& pixel) {
  struct Place {
    std::size_t first;
    double beyond;  ///< Fraction of a pixel beyond `first`.
  };
  const auto place = [](double position, int size) -> Place {
    const double inside = std::clamp(position, 0.0, size - 1.0);
    const double first = std::min(std::floor(inside), std::max(0.0, size - 2.0));
    return {static_cast<std::size_t>(first), inside - first};
  };
  const Place u = place(pixel[0], image.width);
  const Place v = place(pixel[1], image.height);
  const auto width = static_cast<std::size_t>(image.width);
  const std::size_t right = image.width > 1 ? 1 : 0;
  const std::size_t below = image.height > 1 ? width : 0;
  const std::size_t at = v.first * width + u.first;
  const auto along_row = [&](std::size_t i) {
    const double left = image.samples[i];
    return left + u.beyond * (image.samples[i + right] - left);
  };
  const double upper = along_row(at);
  return upper + v.beyond * (along_row(at + below) - upper);
}

/// The derivative of a pixel's ray [1/px] with respect to u (axis 0) or v (axis 1); nullopt if neither neighbour has a ray.
std::optional<Ray> ray_per_pixel(const Lens& source, const Pixel& pixel, const Ray& ray, std::size_t axis) {
  constexpr double kStep = 0.02;  // px
  const auto ray_at = [&](double step) {
    Pixel place = pixel;
    place[axis] += step;
    return source.ray(place);
  };
  const std::optional<Ray> after = ray_at(kStep);
  const std::optional<Ray> before = ray_at(-kStep);
  if (!after && !before) return std::nullopt;
  const Ray& to = after ? *after : ray;
  const Ray& from = before ? *before : ray;
  const double distance = after && before ? 2.0 * kStep : kStep;
  return Ray{(to[0] - from[0]) / distance, (to[1] - from[1]) / distance, (to[2] - from[2]) / distance};
}

/// The solid angle of a pixel [sr]: the area of the parallelogram that the derivatives of its ray span. 0 if there are no
/// derivatives.
double solid_angle(const Lens& source, const Correspondence& sample) {
  const std::optional<Ray> a = ray_per_pixel(source, sample.pixel, sample.ray, 0);
  const std::optional<Ray> b = ray_per_pixel(source, sample.pixel, sample.ray, 1);
  if (!a || !b) return 0.0;
  return std::hypot((*a)[1] * (*b)[2] - (*a)[2] * (*b)[1], (*a)[2] * (*b)[0] - (*a)[0] * (*b)[2],
                    (*a)[0] * (*b)[1] - (*a)[1] * (*b)[0]);
}

/// Multiplies the weights of the samples by the image's grey value or by the solid angle, and scales them to the sum 1. Returns
/// the number of samples that are not black.
std::size_t weigh(const FitWeight& weight, const Lens& source, std::vector<Correspondence>& samples) {
  const double floor = weight.kind == WeightKind::kImage ? kWeightOfBlack * brightest(*weight.density) : 0.0;
  std::size_t counted = 0;
  double sum = 0.0;
  for (Correspondence& sample : samples) {
    const double density =
        weight.kind == WeightKind::kImage ? grey_at(*weight.density, sample.pixel) : solid_angle(source, sample);
    counted += density > floor ? 1 : 0;
    sample.weight *= std::max(density, floor);
    sum += sample.weight;
  }
  for (Correspondence& sample : samples) sample.weight /= sum;
  return counted;
}

/// Samples on an even grid that has about `count` points in the image, at most one per pixel. Points outside the field of view
/// are dropped. An image of weights may have edges anywhere: the few radii of sample() could all be on one side of a circle.
std::vector<Correspondence> grid_of(const Lens& source, const FieldOfView& field_of_view, int count) {
  const auto [width, height] = field_of_view.size;
  const double side = std::max(1.0, std::sqrt(static_cast<double>(width) * height / count));
  const int columns = std::max(1, static_cast<int>(std::lround(width / side)));
  const int rows = std::max(1, static_cast<int>(std::lround(height / side)));
  std::vector<Correspondence> samples;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const Pixel pixel = {(i + 0.5) * width / columns - 0.5, (j + 0.5) * height / rows - 0.5};
      if (const std::optional<Ray> ray = field_of_view.ray(source, pixel)) samples.push_back({*ray, pixel, 1.0});
    }
  }
  return samples;
}

}  // namespace

bool has_equal_weights(const FitWeight& weight) {
  if (weight.kind != WeightKind::kImage) return weight.kind == WeightKind::kPixel;
  const auto [darkest, lightest] = std::ranges::minmax_element(weight.density->samples);
  return *darkest == *lightest && *lightest > 0.0F;
}

bool has_weight(const GreyImage& density, const Lens& source, const FieldOfView& field_of_view) {
  std::size_t i = 0;
  for (int v = 0; v < density.height; ++v) {
    for (int u = 0; u < density.width; ++u, ++i) {
      if (density.samples[i] > 0.0F && field_of_view.ray(source, {static_cast<double>(u), static_cast<double>(v)})) return true;
    }
  }
  return false;
}

WeightedSamples weighted_samples(const FitWeight& weight, const Lens& source, const FieldOfView& field_of_view, int count) {
  if (weight.kind != WeightKind::kImage) {
    WeightedSamples result{sample(source, field_of_view, count), 0};
    result.counted = weight.kind == WeightKind::kPixel ? result.samples.size() : weigh(weight, source, result.samples);
    return result;
  }
  // An image may be black nearly everywhere: makes the grid finer until half of `count` samples are not black.
  constexpr int kFiner = 16;  // points of the first grid, as a multiple of `count`
  constexpr int kMostPoints = 50'000;
  WeightedSamples result;
  int finer = std::min(kFiner * count, kMostPoints);
  while (true) {
    result.samples = grid_of(source, field_of_view, finer);
    result.counted = weigh(weight, source, result.samples);
    if (2 * result.counted >= static_cast<std::size_t>(count) || finer >= kMostPoints) return result;
    finer = std::min(2 * finer, kMostPoints);
  }
}

double weighted_rms(const FitWeight& weight, const Lens& source, const CameraModel& target, const FieldOfView& field_of_view,
                    double max_angle_rad, const Transform* T_target_source) {
  constexpr int kSamples = 3000;
  double squares = 0.0;
  double sum = 0.0;
  for (const Correspondence& sample : weighted_samples(weight, source, field_of_view, kSamples).samples) {
    if (angle_from_axis(sample.ray) > max_angle_rad) continue;
    const std::optional<Pixel> pixel =
        project(target, T_target_source != nullptr ? rotated(*T_target_source, sample.ray) : sample.ray);
    if (!pixel) continue;
    squares += sample.weight * (std::pow((*pixel)[0] - sample.pixel[0], 2) + std::pow((*pixel)[1] - sample.pixel[1], 2));
    sum += sample.weight;
  }
  return sum > 0.0 ? std::sqrt(squares / sum) : 0.0;
}

}  // namespace fca::internal
