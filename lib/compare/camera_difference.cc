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

Judgement judge_pixels(const ModelPair& pair, const Domain& domain, const JudgeOptions& options) {
  if (pair.T_other_reference == nullptr) return judge(pair.reference, pair.other, domain, options);
  const Projection projection = [&pair](const Ray& ray) { return project(pair.other, turned(pair, ray)); };
  return judge(pair.reference, projection, domain, options);
}

/// The judge measures how far a pixel is from its own: it is given one that is as far away as the angle has degrees.
Judgement judge_angles(const ModelPair& pair, const Domain& domain, const JudgeOptions& options) {
  const Projection projection = [&pair](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> pixel = project(pair.reference, ray);
    if (!pixel || !project(pair.other, turned(pair, ray))) return std::nullopt;
    const std::optional<Ray> other = unproject(pair.other, *pixel);
    if (!other) return std::nullopt;
    return Pixel{(*pixel)[0] + angle_between(turned(pair, ray), *other) * kDegreesPerRadian, (*pixel)[1]};
  };
  return judge(pair.reference, projection, domain, options);
}

AngleSummary angle_summary(const Judgement& judgement) {
  AngleSummary summary{judgement.error.rms, judgement.error.max, judgement.error.max_at, {}};
  for (const ErrorBand& band : judgement.bands) summary.bands.push_back({band.from_deg, band.to_deg, band.rms_px, band.max_px});
  return summary;
}

/// What is left of a judgement where nothing but rounding could differ.
void clear_errors(CameraDifference& difference) {
  ErrorSummary& error = difference.judgement.error;
  error = {};
  error.bound = 0.0;
  for (ErrorBand& band : difference.judgement.bands) band.rms_px = band.max_px = 0.0;
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

bool same(const Judgement& judgement) {
  constexpr double kNoArea = 1e-6;
  return judgement.error.max <= kSamePx && judgement.coverage.unrepresentable <= kNoArea;
}

/// By bisection: the largest error within a cone grows with it.
double same_to_deg(const ModelPair& pair, const Domain& domain, const Judgement& whole) {
  if (same(whole)) return domain.max_angle_rad * kDegreesPerRadian;
  if (!same_at_axis(pair)) return 0.0;
  constexpr double kPrecision = 0.05 / kDegreesPerRadian;
  double inside = 0.0;
  double outside = domain.max_angle_rad;
  Domain cone = domain;
  while (outside - inside > kPrecision) {
    cone.max_angle_rad = 0.5 * (inside + outside);
    (same(judge_pixels(pair, cone, {.bound = false})) ? inside : outside) = cone.max_angle_rad;
  }
  return inside * kDegreesPerRadian;
}

}  // namespace

CameraDifference difference_of(const ModelPair& pair, const Domain& domain, const JudgeOptions& options) {
  CameraDifference difference;
  difference.judgement = judge_pixels(pair, domain, options);
  JudgeOptions lattice = options;
  lattice.bound = false;
  const bool identical = pair.T_other_reference == nullptr && pair.reference == pair.other;
  difference.angle = angle_summary(identical ? difference.judgement : judge_angles(pair, domain, lattice));
  if (identical) clear_errors(difference);
  difference.same_to_deg = same_to_deg(pair, domain, difference.judgement);
  return difference;
}

double misfit_px(const CameraModel& reference, const CameraModel& other, const Domain& domain) {
  const Judgement judgement = judge(reference, other, domain, {.bound = false});
  const double diagonal = std::hypot(domain.size.width, domain.size.height);
  const double scored = judgement.coverage.scored;
  const double without = judgement.coverage.unrepresentable;
  if (!(scored + without > 0.0)) return diagonal;
  const double square = judgement.error.rms * judgement.error.rms;
  return std::sqrt((scored * square + without * diagonal * diagonal) / (scored + without));
}

}  // namespace fca::internal
