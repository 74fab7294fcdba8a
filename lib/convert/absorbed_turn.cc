// SPDX-License-Identifier: BSD-3-Clause
#include "absorbed_turn.h"

#include "evaluation/turned.h"
#include "fitting/turn.h"
#include "sampling/weights.h"

#include <fca/code.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

namespace fca {

AbsorbedTurn::AbsorbedTurn(const Transform& rotation, double rms_px, double max_px)
    : T_target_source(rotation),
      angle_deg(angle_between(rotation, Transform()) * 180.0 / std::numbers::pi),
      rms_before_px(rms_px),
      max_before_px(max_px) {}

namespace internal {

namespace {

/// The samples to which a rotation is fitted: about `count` rays inside the angle up to which the fit is valid.
std::vector<Correspondence> samples_for_turn(const FitTask& task, double max_angle_rad, int count) {
  FieldOfView field_of_view = task.field_of_view;
  field_of_view.max_angle_rad = std::min(field_of_view.max_angle_rad, max_angle_rad);
  return weighted_samples(task.options.weight, task.camera.model, field_of_view, count).samples;
}

/// True if the rotation makes the rms that the fit minimises (weighted, if the options have weights) at least 1 % smaller.
bool is_better(const FitTask& task, const FieldOfViewFit& straight, const TurnedFit& turned, double rms_straight_px,
               double rms_turned_px) {
  constexpr double kLargestRatio = 0.99;
  const FitWeight& weight = task.options.weight;
  if (has_equal_weights(weight)) return rms_turned_px < kLargestRatio * rms_straight_px;
  return weighted_rms(weight, task.camera.model, turned.fitted.model, task.field_of_view, straight.fitted.max_angle_rad,
                      &turned.T_target_source) < kLargestRatio * straight.rms_px;
}

}  // namespace

void absorb_turn(const FitTask& task, const DegreeFit& fit, Conversion& conversion, Diagnostics& diagnostics) {
  constexpr int kSamples = 800;
  const SampledFit& straight = fit.fit.fitted;
  const std::optional<TurnedFit> turned =
      fit_with_turn(*straight.model, samples_for_turn(task, straight.max_angle_rad, kSamples), fit.ranges);
  ConversionReport& report = conversion.report;
  if (turned && validate(turned->fitted.model).empty()) {
    ErrorStatistics statistics = evaluate_turned(task.camera.model, turned->fitted.model, turned->T_target_source,
                                                 task.field_of_view, straight.max_angle_rad, task.options.every_pixel);
    const ErrorSummary& before = report.statistics.error;
    if (is_better(task, fit.fit, *turned, before.rms, statistics.error.rms) && covers_as_much(report.statistics, statistics)) {
      report.turn = AbsorbedTurn{turned->T_target_source, before.rms, before.max};
      report.statistics = std::move(statistics);
      report.at_bound = turned->fitted.at_bound;
      conversion.camera.model = turned->fitted.model;
      return;
    }
  }
  diagnostics.add(Code::kTurnDoesNotHelp, {task.camera.name});
}

std::optional<TurnOffer> offered_turn(const FitTask& task, const DegreeFit& fit, double rms_px) {
  constexpr double kVisiblePx = 0.02;
  constexpr double kLargestRatio = 0.8;  // of the rms with a rotation to that without
  constexpr int kSamples = 200;
  if (rms_px < kVisiblePx) return std::nullopt;
  const SampledFit& fitted = fit.fit.fitted;
  const std::optional<TurnEstimate> turned =
      estimate_turn(*fitted.model, samples_for_turn(task, fitted.max_angle_rad, kSamples), fit.ranges, kLargestRatio);
  if (!turned) return std::nullopt;
  return TurnOffer{turned->angle_rad * 180.0 / std::numbers::pi, turned->ratio * rms_px};
}

}  // namespace internal

}  // namespace fca
