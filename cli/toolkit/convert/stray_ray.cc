// SPDX-License-Identifier: BSD-3-Clause
#include "stray_ray.h"

#include <fca/code.h>
#include <fca/convert/convert.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fca {

namespace {

/// The distance [px] between the pixel of the entry and the pixel to which the model projects its ray. Infinite if the model
/// has no pixel for the ray.
double error_of(const CameraModel& model, const Correspondence& entry) {
  const std::optional<Pixel> pixel = project(model, entry.ray);
  if (!pixel) return std::numeric_limits<double>::infinity();
  return std::hypot((*pixel)[0] - entry.pixel[0], (*pixel)[1] - entry.pixel[1]);
}

}  // namespace

std::optional<Message> stray_ray(const ConvertedCamera& camera) {
  const std::vector<Correspondence>& rays = camera.source.rays;
  if (rays.empty() || !camera.target.rays.empty()) return std::nullopt;
  std::vector<double> errors;
  errors.reserve(rays.size());
  for (const Correspondence& entry : rays) errors.push_back(error_of(camera.target.model, entry));
  std::vector<double> sorted = errors;
  std::ranges::sort(sorted);
  // A ray is suspect if its error is far above the upper quartile of all errors, and visible.
  constexpr double kTimesQuartile = 5.0;
  constexpr double kVisiblePx = 0.5;
  const double limit_px = std::max(kTimesQuartile * sorted[sorted.size() * 3 / 4], kVisiblePx);
  Camera others = camera.source;
  others.rays.clear();
  std::vector<Correspondence> suspects;
  for (std::size_t i = 0; i < rays.size(); ++i) (errors[i] <= limit_px ? others.rays : suspects).push_back(rays[i]);
  // If more than 3 rays, and more than 2 % of the table, have large errors, the model itself is the cause.
  constexpr std::size_t kMaxSuspects = 3;
  if (suspects.empty() || suspects.size() > std::max(kMaxSuspects, rays.size() / 50)) return std::nullopt;
  double weight_sum = 0.0;
  for (const Correspondence& entry : others.rays) weight_sum += entry.weight;
  for (Correspondence& entry : others.rays) entry.weight /= weight_sum;

  ConvertOptions options;
  options.model = std::string(camera.target.lens_id());
  Diagnostics ignored;
  const std::optional<Conversion> fit = convert(others, options, ignored);
  if (!fit) return std::nullopt;
  const auto error_of_fit = [&fit](const Correspondence& entry) { return error_of(fit->camera.model, entry); };
  const Correspondence& worst = *std::ranges::max_element(suspects, {}, error_of_fit);
  const double distance_px = error_of_fit(worst);
  // If the model describes the lens badly, the errors grow towards the edge, but none is ten times as large as all others.
  constexpr double kTimesOthers = 10.0;
  if (!(distance_px > kTimesOthers * std::max(fit->report.statistics.error.max, kVisiblePx / kTimesOthers)))
    return std::nullopt;
  if (!std::isfinite(distance_px)) return Message{Code::kRayOutside, {camera.source.name, worst.pixel[0], worst.pixel[1]}};
  return Message{Code::kRayApart,
                 {camera.source.name, worst.pixel[0], worst.pixel[1], distance_px, fit->report.statistics.error.max}};
}

}  // namespace fca
