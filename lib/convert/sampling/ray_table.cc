// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/ray_table.h>

#include "../evaluation/summary.h"

#include <fca/models/linear_fit.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace fca {

std::optional<LensCentre> centre_of(std::span<const Correspondence> table) {
  std::vector<Correspondence> inner(table.begin(), table.end());
  std::ranges::sort(inner, {}, [](const Correspondence& c) { return angle_from_axis(c.ray); });
  constexpr std::size_t kFewestInnerRays = 6;
  inner.resize(std::min(inner.size(), std::max(kFewestInnerRays, inner.size() / 4)));
  LensCentre centre;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    internal::LinearFit<2> fit;
    double smallest = std::numeric_limits<double>::infinity();
    double largest = -smallest;
    for (const Correspondence& c : inner) {
      const double sine = std::hypot(c.ray[0], c.ray[1]);
      const double along = sine > 0.0 ? angle_from_axis(c.ray) * c.ray[axis] / sine : 0.0;
      fit.add({along, 1.0}, c.pixel[axis], c.weight);
      smallest = std::min(smallest, along);
      largest = std::max(largest, along);
    }
    constexpr double kSmallestRange = 1e-9;  // rad
    if (!(largest - smallest > kSmallestRange)) return std::nullopt;
    std::array<double, 2> solution{};
    fit.solve(solution.data());
    if (!(solution[0] > 0.0) || !std::isfinite(solution[0]) || !std::isfinite(solution[1])) return std::nullopt;
    centre.focal[axis] = solution[0];
    centre.point[axis] = solution[1];
  }
  return centre;
}

namespace {

/// A ray and its pixel.
struct Sighting {
  Correspondence entry;
  double radius_px = 0.0;  ///< The distance of the pixel from the axis's pixel.
};

/// Rays at one azimuth [rad] with increasing angles from the axis. They end where a ray has no pixel, or the image radius no
/// longer grows, at the latest at max_angle_rad.
std::vector<Sighting> sightings_along(const Projection& projection, const Pixel& centre, double azimuth, double max_angle_rad) {
  constexpr int kSteps = 400;
  std::vector<Sighting> line;
  double last = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    const double angle = max_angle_rad * i / kSteps;
    const Ray ray = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
    const std::optional<Pixel> pixel = projection(ray);
    if (!pixel) break;
    const double radius = std::hypot((*pixel)[0] - centre[0], (*pixel)[1] - centre[1]);
    if (!(radius > last) || !std::isfinite(radius)) break;
    last = radius;
    line.push_back({{ray, *pixel, 0.0}, radius});
  }
  return line;
}

/// Azimuths about the pixel `centre` [rad], ascending: evenly spaced ones, and those of the image's corners.
std::vector<double> azimuths_about(const Pixel& centre, const ImageSize& size) {
  constexpr int kEvenlySpaced = 64;
  constexpr std::size_t kCorners = 4;
  std::vector<double> azimuths;
  azimuths.reserve(kEvenlySpaced + kCorners);
  for (int i = 0; i < kEvenlySpaced; ++i)
    azimuths.push_back(2.0 * std::numbers::pi * (i + 0.5) / kEvenlySpaced - std::numbers::pi);
  for (const double u : {-0.5, size.width - 0.5}) {
    for (const double v : {-0.5, size.height - 0.5}) azimuths.push_back(std::atan2(v - centre[1], u - centre[0]));
  }
  std::ranges::sort(azimuths);
  return azimuths;
}

/// True if the pixel lies in the image, including the outer halves of the border's pixels.
bool is_in(const ImageSize& size, const Pixel& pixel) {
  return pixel[0] >= -0.5 && pixel[1] >= -0.5 && pixel[0] <= size.width - 0.5 && pixel[1] <= size.height - 0.5;
}

}  // namespace

std::optional<Camera> measured(Camera camera, const Projection& projection, double max_angle_rad) {
  constexpr int kRadii = 40;
  const std::optional<Pixel> centre = projection({0.0, 0.0, 1.0});
  if (!centre || !camera.image_size) return std::nullopt;
  camera.rays.clear();
  const std::vector<double> azimuths = azimuths_about(*centre, *camera.image_size);
  for (std::size_t i = 0; i < azimuths.size(); ++i) {
    const double full_turn = 2.0 * std::numbers::pi;
    const double azimuth_before = i > 0 ? azimuths[i - 1] : azimuths.back() - full_turn;
    const double azimuth_after = i + 1 < azimuths.size() ? azimuths[i + 1] : azimuths.front() + full_turn;
    std::vector<Sighting> line = sightings_along(projection, *centre, azimuths[i], max_angle_rad);
    while (!line.empty() && !is_in(*camera.image_size, line.back().entry.pixel)) line.pop_back();
    if (line.empty()) continue;
    const double furthest = line.back().radius_px;
    double radius_before = 0.0;
    for (const Sighting& sighting : line) {
      if (sighting.radius_px - radius_before < furthest / kRadii && &sighting != &line.back()) continue;
      if (is_in(*camera.image_size, sighting.entry.pixel)) {
        camera.rays.push_back(sighting.entry);
        camera.rays.back().weight =
            sighting.radius_px * (sighting.radius_px - radius_before) * (azimuth_after - azimuth_before);
      }
      radius_before = sighting.radius_px;
    }
  }
  double sum = 0.0;
  for (const Correspondence& entry : camera.rays) sum += entry.weight;
  for (Correspondence& entry : camera.rays) entry.weight /= sum;
  const std::optional<LensCentre> found = camera.rays.size() < kFewestRays ? std::nullopt : centre_of(camera.rays);
  if (!found) return std::nullopt;
  camera.model = Intrinsics<Pinhole>{{found->focal[0], found->focal[1], (*centre)[0], (*centre)[1]}};
  return camera;
}

ErrorStatistics evaluate_table(std::span<const Correspondence> table, const FieldOfView& field_of_view,
                               const Projection& target) {
  constexpr int kBinsPerOctave = 1024;  // percentiles to 0.1 %
  internal::Summary summary(kBinsPerOctave);
  internal::Batch batch;
  batch.spread.fill(0.0);
  std::size_t count = 0;
  const auto add = [&] {
    summary.add(batch, count);
    count = 0;
  };
  for (const Correspondence& c : table) {
    batch.u[count] = c.pixel[0];
    batch.v[count] = c.pixel[1];
    batch.weight[count] = c.weight;
    batch.z[count] = std::cos(angle_from_axis(c.ray));
    batch.verdict[count] = internal::Verdict::kUnrepresentable;
    if (const std::optional<Pixel> image = target(c.ray)) {
      const double error = std::hypot((*image)[0] - c.pixel[0], (*image)[1] - c.pixel[1]);
      if (std::isfinite(error)) {
        batch.error[count] = error;
        batch.verdict[count] = internal::Verdict::kScored;
      }
    }
    if (++count == internal::Batch::kSize) add();
  }
  add();
  return summary.statistics(field_of_view);
}

ErrorSummary evaluate(std::span<const Correspondence> table, const Projection& target) {
  return evaluate_table(table, {}, target).error;
}

}  // namespace fca
