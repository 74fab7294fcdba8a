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

/// The distance [px] between the entry's pixel and the model's; infinite if the model has none.
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
  constexpr double kTimes = 5.0;
  constexpr double kSeenPx = 0.5;
  const double far = std::max(kTimes * sorted[sorted.size() * 3 / 4], kSeenPx);
  Camera others = camera.source;
  others.rays.clear();
  std::vector<Correspondence> strays;
  for (std::size_t i = 0; i < rays.size(); ++i) (errors[i] <= far ? others.rays : strays).push_back(rays[i]);
  constexpr std::size_t kFew = 3;
  if (strays.empty() || strays.size() > std::max(kFew, rays.size() / 50)) return std::nullopt;
  double sum = 0.0;
  for (const Correspondence& entry : others.rays) sum += entry.weight;
  for (Correspondence& entry : others.rays) entry.weight /= sum;

  ConvertOptions options;
  options.model = std::string(camera.target.lens_id());
  Diagnostics ignored;
  const std::optional<Conversion> fit = convert(others, options, ignored);
  if (!fit) return std::nullopt;
  const auto of_fit = [&fit](const Correspondence& entry) { return error_of(fit->camera.model, entry); };
  const Correspondence& worst = *std::ranges::max_element(strays, {}, of_fit);
  const double off = of_fit(worst);
  // For a lens that the model describes badly, errors grow towards the edge; a single one does not exceed all others tenfold.
  constexpr double kLeap = 10.0;
  if (!(off > kLeap * std::max(fit->report.statistics.error.max, kSeenPx / kLeap))) return std::nullopt;
  if (!std::isfinite(off)) return Message{Code::kRayOutside, {camera.source.name, worst.pixel[0], worst.pixel[1]}};
  return Message{Code::kRayApart, {camera.source.name, worst.pixel[0], worst.pixel[1], off, fit->report.statistics.error.max}};
}

}  // namespace fca
