// SPDX-License-Identifier: BSD-3-Clause
#include "table_conversion.h"

#include "fitting/degree.h"
#include "fitting/fit_field_of_view.h"
#include "fitting/fit_model.h"
#include "fitting/turn.h"

#include <fca/code.h>
#include <fca/convert/ray_table.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace fca::internal {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
/// Perspective models have pixels only for rays at a smaller angle from the axis.
constexpr double kPerspectiveLimitDeg = 90.0;

using Table = std::vector<Correspondence>;

/// The entries of a table up to `max_angle_rad` from the axis, with their weights scaled to the sum 1.
Table inside(const Table& table, double max_angle_rad) {
  Table result;
  std::ranges::copy_if(table, std::back_inserter(result),
                       [max_angle_rad](const Correspondence& entry) { return angle_from_axis(entry.ray) <= max_angle_rad; });
  double sum = 0.0;
  for (const Correspondence& entry : result) sum += entry.weight;
  for (Correspondence& entry : result) entry.weight /= sum;
  return result;
}

/// The largest angle of a ray from the axis [rad].
double largest_angle(const Table& table) {
  double largest = 0.0;
  for (const Correspondence& entry : table) largest = std::max(largest, angle_from_axis(entry.ray));
  return largest;
}

/// The largest angle from the axis of a ray of a real lens.
constexpr double kLargestLensDeg = 150.0;
/// The largest share of rays beyond that angle that may be mistakes. With a larger share, the table is not one lens.
constexpr double kLargestShareBeyondLens = 0.02;

/// The weighted share of rays further from the axis than kLargestLensDeg.
double share_beyond_lens(const Table& table) {
  double share = 0.0;
  for (const Correspondence& entry : table)
    share += angle_from_axis(entry.ray) > kLargestLensDeg * kRadiansPerDegree ? entry.weight : 0.0;
  return share;
}

/// The entries of the camera's table inside the image, the lens circle and the options' angle.
Table entries_to_fit(const Camera& camera, const ConvertOptions& options) {
  Table table = camera.rays;
  if (camera.image_size) {
    const auto [width, height] = *camera.image_size;
    std::erase_if(table, [right = width - 0.5, bottom = height - 0.5](const Correspondence& entry) {
      const auto [u, v] = entry.pixel;
      return u < -0.5 || v < -0.5 || u > right || v > bottom;
    });
  }
  if (camera.lens_circle) {
    std::erase_if(table, [&camera](const Correspondence& entry) { return !camera.lens_circle->contains(entry.pixel); });
  }
  return inside(table, options.max_angle_rad.value_or(std::numbers::pi));
}

/// A fit to a table.
struct TableFit {
  std::optional<FittedModel> model;         ///< nullopt if the fit failed.
  double max_angle_rad = std::numbers::pi;  ///< The angle up to which the model was fitted; pi if to all entries.
  std::size_t entries = 0;                  ///< The number of entries to which it was fitted.
  int degree = 0;                           ///< The polynomial's degree; 0 if the model has none to choose.
};

/// True if the fit describes its entries, by the rule in fit_field_of_view.h.
bool describes(const FittedModel& fit, std::string_view target) {
  constexpr double kLargestRmsPx = 1.0;
  return fit.reaches_all && (!is_perspective(target) || fit.rms_px <= kLargestRmsPx);
}

/// Fits the target to the whole table. If it does not describe all entries and the angle may be reduced, fits it up to the
/// largest angle that it describes; without such an angle, returns the fit to the whole table.
TableFit fit_table(const Table& table, const LensCentre& centre, const ModelInfo& target, const DegreeRanges& degree,
                   bool reduce_angle) {
  TableFit whole{fit_model(target.id, table, centre, degree.ranges), std::numbers::pi, table.size(), degree.degree};
  if (!reduce_angle || (whole.model && describes(*whole.model, target.id))) return whole;
  constexpr int kStepDeg = 5;
  const double furthest = largest_angle(table) / kRadiansPerDegree;
  const double below = is_perspective(target.id) ? std::min(furthest, kPerspectiveLimitDeg) : furthest;
  for (int deg = static_cast<int>(std::ceil(below / kStepDeg) - 1.0) * kStepDeg; deg >= kStepDeg; deg -= kStepDeg) {
    const double max_angle_rad = deg * kRadiansPerDegree;
    const Table narrower = inside(table, max_angle_rad);
    if (too_few(narrower.size(), target)) break;
    std::optional<FittedModel> fit = fit_model(target.id, narrower, centre, degree.ranges);
    if (fit && describes(*fit, target.id)) return {std::move(fit), max_angle_rad, narrower.size(), degree.degree};
  }
  return whole;
}

/// The fit of the lowest degree that is nearly as good as the best one. Only degrees whose fits cover at least as large an
/// angle as the lowest degree's are considered.
TableFit fit_degrees_of_table(const Table& table, const LensCentre& centre, const ModelInfo& target,
                              const ConvertOptions& options) {
  std::vector<TableFit> fits;
  for (const DegreeRanges& degree : degrees_to_try(target, options)) {
    TableFit fit = fit_table(table, centre, target, degree, options.reduce_angle);
    const bool is_first = fits.empty();
    if (!is_first && (!fit.model || !fits.front().model || fit.max_angle_rad < fits.front().max_angle_rad)) continue;
    fits.push_back(std::move(fit));
    if (is_first && !fits.front().model) break;
    if (fits.back().model->rms_px < kGoodEnoughPx) break;
  }
  const auto rms_of = [](const TableFit& fit) { return fit.model ? fit.model->rms_px : 0.0; };
  const double enough = std::max(kGoodEnoughPx, kNearlyAsGood * rms_of(*std::ranges::min_element(fits, {}, rms_of)));
  return *std::ranges::find_if(fits, [&](const TableFit& fit) { return rms_of(fit) <= enough; });
}

}  // namespace

std::optional<Conversion> convert_table(const Camera& camera, const ModelInfo& target, const ConvertOptions& options,
                                        Diagnostics& diagnostics) {
  using Clock = std::chrono::steady_clock;
  if (options.objective != Objective::kRms) {
    diagnostics.add(Code::kRaysFittedForRms, {camera.name});
    return std::nullopt;
  }
  if (options.weight.kind != WeightKind::kPixel) {
    diagnostics.add(Code::kRaysCountAlike, {camera.name});
    return std::nullopt;
  }
  const Table table = entries_to_fit(camera, options);
  if (const double share = share_beyond_lens(table); share > kLargestShareBeyondLens) {
    diagnostics.add(Code::kRaysAllAround, {camera.name, 100.0 * share});
    return std::nullopt;
  }
  if (too_few(table.size(), target)) {
    diagnostics.add(Code::kTooFewRaysToFit, {camera.name, target.id});
    return std::nullopt;
  }
  const LensCentre centre{central_focal_lengths(camera.model), principal_point(camera.model)};
  const Clock::time_point start = Clock::now();
  const TableFit fit = fit_degrees_of_table(table, centre, target, options);
  const std::chrono::duration<double, std::micro> time = Clock::now() - start;
  if (!fit.model) {
    diagnostics.add(Code::kFitFailed, {camera.name, target.id});
    return std::nullopt;
  }
  Conversion conversion{camera, {}};
  conversion.camera.rays.clear();
  conversion.camera.model = fit.model->model;
  ConversionReport& report = conversion.report;
  report.from_model = camera.lens_id();
  report.to_model = target.id;
  report.angle_reduced = fit.max_angle_rad < std::numbers::pi;
  if (report.angle_reduced) {
    diagnostics.add(Code::kTargetCannotReach, {camera.name, target.id, fit.max_angle_rad / kRadiansPerDegree});
  }
  const double furthest = largest_angle(table);
  report.scored_to_deg = std::min({furthest, fit.max_angle_rad, max_angle(fit.model->model)}) / kRadiansPerDegree;
  report.fit = {static_cast<int>(fit.entries), fit.model->iterations, time.count()};
  report.degree = fit.degree;
  report.at_bound = fit.model->at_bound;

  Transform T_target_source;
  if (options.absorb_turn) {
    const Table fitted = inside(table, fit.max_angle_rad);
    if (std::optional<TurnedFit> turned = fit_with_turn(*fit.model, fitted, options.ranges)) {
      T_target_source = turned->T_target_source;
      report.turn = AbsorbedTurn{T_target_source, fit.model->rms_px, 0.0};
      conversion.camera.model = turned->fitted.model;
      report.at_bound = turned->fitted.at_bound;
    } else {
      diagnostics.add(Code::kTurnDoesNotHelp, {camera.name});
    }
  }
  FieldOfView field_of_view;
  field_of_view.max_angle_rad = furthest;
  field_of_view.why = {Code::kRaysEndThere};
  report.statistics = evaluate_table(table, field_of_view, [&](const Ray& ray) {
    return angle_from_axis(ray) <= fit.max_angle_rad ? project(conversion.camera.model, rotated(T_target_source, ray))
                                                     : std::nullopt;
  });
  diagnostics.add(Code::kOnlyRaysCompared, {camera.name, table.size()});
  if (!(report.statistics.coverage.scored > 0.0)) {
    diagnostics.add(Code::kNoPartCompared, {camera.name, target.id});
    return std::nullopt;
  }
  return conversion;
}

}  // namespace fca::internal
