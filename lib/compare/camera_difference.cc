// SPDX-License-Identifier: BSD-3-Clause
#include "camera_difference.h"

#include <fca/rig/rotation.h>

#include <cmath>
#include <numbers>

namespace fca::internal {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// The other camera's unit ray to what the reference sees along `ray`.
Ray turned(const ModelPair& pair, const Ray& ray) {
  if (pair.T_other_reference == nullptr) return ray;
  Ray result = rotated(*pair.T_other_reference, ray);
  if (!pair.distance_m) return result;
  for (int i = 0; i < 3; ++i) result[static_cast<std::size_t>(i)] += (*pair.T_other_reference)(i, 3) / *pair.distance_m;
  const double length = std::hypot(result[0], result[1], result[2]);
  for (double& element : result) element /= length;
  return result;
}

/// Between two unit rays (Kahan: accurate for all angles).
double angle_between(const Ray& a, const Ray& b) {
  const double across = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  const double along = std::hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
  return 2.0 * std::atan2(across, along);
}

ErrorStatistics evaluate_pixels(const ModelPair& pair, const FieldOfView& field_of_view, const EvaluateOptions& options) {
  if (pair.T_other_reference == nullptr) return evaluate(pair.reference, pair.other, field_of_view, options);
  const Projection projection = [&pair](const Ray& ray) { return project(pair.other, turned(pair, ray)); };
  return evaluate(pair.reference, projection, field_of_view, options);
}

/// evaluate() measures how far a pixel is from its own: it gets one that is as far away as the angle has degrees.
ErrorStatistics evaluate_angles(const ModelPair& pair, const FieldOfView& field_of_view, const EvaluateOptions& options) {
  const Projection projection = [&pair](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> pixel = project(pair.reference, ray);
    if (!pixel || !project(pair.other, turned(pair, ray))) return std::nullopt;
    const std::optional<Ray> other = unproject(pair.other, *pixel);
    if (!other) return std::nullopt;
    return Pixel{(*pixel)[0] + angle_between(turned(pair, ray), *other) * kDegreesPerRadian, (*pixel)[1]};
  };
  return evaluate(pair.reference, projection, field_of_view, options);
}

AngleSummary angle_summary(const ErrorStatistics& statistics) {
  AngleSummary summary{statistics.error.rms, statistics.error.max, statistics.error.max_at, {}};
  for (const ErrorBand& band : statistics.bands)
    summary.bands.push_back({band.from_deg, band.to_deg, band.rms_px, band.max_px});
  return summary;
}

/// What is left of the statistics where nothing but rounding could differ.
void clear_errors(CameraDifference& difference) {
  ErrorSummary& error = difference.statistics.error;
  error = {};
  error.bound = 0.0;
  for (ErrorBand& band : difference.statistics.bands) band.rms_px = band.max_px = 0.0;
  difference.angle.rms_deg = difference.angle.max_deg = 0.0;
  difference.angle.max_at = {};
  for (AngleBand& band : difference.angle.bands) band.rms_deg = band.max_deg = 0.0;
}

/// The two agree at the axis?
bool same_at_axis(const ModelPair& pair) {
  const Pixel centre = principal_point(pair.reference);
  const std::optional<Pixel> pixel = project(pair.other, turned(pair, {0.0, 0.0, 1.0}));
  return pixel && std::hypot((*pixel)[0] - centre[0], (*pixel)[1] - centre[1]) <= kSamePx;
}

bool same(const ErrorStatistics& statistics) {
  constexpr double kNoArea = 1e-6;
  return statistics.error.max <= kSamePx && statistics.coverage.unrepresentable <= kNoArea;
}

/// By bisection: the largest error up to an angle grows with it.
double same_to_deg(const ModelPair& pair, const FieldOfView& field_of_view, const ErrorStatistics& whole) {
  if (same(whole)) return field_of_view.max_angle_rad * kDegreesPerRadian;
  if (!same_at_axis(pair)) return 0.0;
  constexpr double kPrecision = 0.05 / kDegreesPerRadian;
  double inside = 0.0;
  double outside = field_of_view.max_angle_rad;
  FieldOfView narrower = field_of_view;
  while (outside - inside > kPrecision) {
    narrower.max_angle_rad = 0.5 * (inside + outside);
    (same(evaluate_pixels(pair, narrower, {.bound = false})) ? inside : outside) = narrower.max_angle_rad;
  }
  return inside * kDegreesPerRadian;
}

}  // namespace

CameraDifference difference_of(const ModelPair& pair, const FieldOfView& field_of_view, const EvaluateOptions& options) {
  CameraDifference difference;
  difference.statistics = evaluate_pixels(pair, field_of_view, options);
  EvaluateOptions lattice = options;
  lattice.bound = false;
  const bool identical = pair.T_other_reference == nullptr && pair.reference == pair.other;
  difference.angle = angle_summary(identical ? difference.statistics : evaluate_angles(pair, field_of_view, lattice));
  if (identical) clear_errors(difference);
  difference.same_to_deg = same_to_deg(pair, field_of_view, difference.statistics);
  return difference;
}

double misfit_px(const CameraModel& reference, const CameraModel& other, const FieldOfView& field_of_view) {
  const ErrorStatistics statistics = evaluate(reference, other, field_of_view, {.bound = false});
  const double diagonal = std::hypot(field_of_view.size.width, field_of_view.size.height);
  const double scored = statistics.coverage.scored;
  const double without = statistics.coverage.unrepresentable;
  if (!(scored + without > 0.0)) return diagonal;
  const double square = statistics.error.rms * statistics.error.rms;
  return std::sqrt((scored * square + without * diagonal * diagonal) / (scored + without));
}

}  // namespace fca::internal
