// SPDX-License-Identifier: BSD-3-Clause
#include "fit_field_of_view.h"

#include "../sampling/edge_samples.h"
#include "../sampling/weights.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fca::internal {

namespace {

using Clock = std::chrono::steady_clock;
using Micros = std::chrono::duration<double, std::micro>;

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
constexpr double kRightAngle = std::numbers::pi / 2.0;

/// Fits the target to about `count` samples of the field of view. Starts from `coarser`, a fit to fewer samples, or from the
/// model's own starts if `coarser` is null.
SampledFit fit_to_samples(const FitTask& task, int count, const FittedModel* coarser = nullptr) {
  WeightedSamples weighted = weighted_samples(task.options.weight, task.camera.model, task.field_of_view, count);
  std::vector<Correspondence>& samples = weighted.samples;
  SampledFit result;
  result.samples = weighted.counted;
  if (!too_few(weighted.counted, task.target)) {
    if (may_end_early(task.target.id)) add_edge(task.camera.model, task.field_of_view, samples);
    result.model = coarser != nullptr
                       ? fit_from(coarser->model, samples, task.options.ranges)
                       : fit_model(task.target.id, samples, task.centre, task.options.ranges, MustReach::kEverySample);
  }
  return result;
}

/// The larger of the rms over the image (`rms_px`) and the rms on the fit's samples, divided by the smaller one; 1 if they
/// differ by at most 1e-6 px. The rms over the image can be twice as large if the errors vary much between the samples
/// (rational beyond 70 degrees). It is smaller if the few samples happen to be at pixels with large errors.
double rms_ratio_to_samples(double rms_px, const FittedModel& fitted) {
  constexpr double kNegligiblePx = 1e-6;
  const auto [smaller, larger] = std::minmax(rms_px, fitted.rms_px);
  return !fitted.reaches_all || larger <= smaller + kNegligiblePx ? 1.0 : larger / smaller;
}

/// The rms [px] over the image, with the weights that the fit minimises.
double rms_of(const FitTask& task, const SampledFit& fitted, const ErrorStatistics& statistics) {
  if (has_equal_weights(task.options.weight)) return statistics.error.rms;
  return weighted_rms(task.options.weight, task.camera.model, fitted.model->model, task.field_of_view, fitted.max_angle_rad);
}

/// Fits the target to the field of view and computes its errors over the image. Repeats both with twice as many samples while
/// that helps. A fit without a pixel for some samples gets no score.
FieldOfViewFit fit_and_score(const FitTask& task) {
  constexpr int kMostDoublings = 3;
  // Ratios of the rms over the image and on the samples: the fit is repeated if they differ by more. After a fit that did not
  // help they must differ by much more.
  constexpr double kSameRmsRatio = 1.01;  // the rms over the lattice is not more exact
  constexpr double kVeryDifferentRmsRatio = 1.2;
  constexpr double kUsefulRmsRatio = 0.999;  // a fit helps if its rms is below this fraction of the one before
  constexpr double kUsefulShare = 1e-3;      // or if it has pixels for this much more of the image
  constexpr double kNegligiblePx = 1e-4;
  FieldOfViewFit result;
  for (int doubling = 0; doubling <= kMostDoublings; ++doubling) {
    const bool is_first = doubling == 0;
    const Clock::time_point start = Clock::now();
    SampledFit finer = fit_to_samples(task, task.options.samples << doubling, is_first ? nullptr : &*result.fitted.model);
    result.time += Clock::now() - start;
    if (!finer.model || !finer.model->reaches_all) {
      if (is_first) result.fitted = std::move(finer);
      break;
    }
    Score score = score_on_lattice({task.camera.model, &finer.model->model, nullptr, task.field_of_view, finer.max_angle_rad});
    const ErrorStatistics& statistics = score.statistics;
    const ErrorStatistics& before = result.score.statistics;
    const double rms_px = rms_of(task, finer, statistics);
    const bool helps = is_first || statistics.coverage.scored > before.coverage.scored + kUsefulShare ||
                       rms_px < kUsefulRmsRatio * result.rms_px;
    const double ratio = rms_ratio_to_samples(rms_px, *finer.model);
    const bool misses_edge = statistics.coverage.unrepresentable > kVeryEdge;
    if (helps) {
      result.fitted = std::move(finer);
      result.score = std::move(score);
      result.rms_px = rms_px;
    }
    // A pole between two samples costs the fit nothing, and the errors at the samples and over the image may agree by chance. A
    // model that may have poles is therefore always fitted a second time.
    if (is_first && has_poles(task.target.id) && rms_px > kNegligiblePx) continue;
    if (ratio <= (helps ? kSameRmsRatio : kVeryDifferentRmsRatio) && !(helps && misses_edge)) break;
  }
  return result;
}

/// True if the model has a pixel for every ray that was fitted, except at the very edge (kVeryEdge). Its image radius then
/// grows up to the edge, since a model's domain ends at the angle at which the radius stops growing.
bool reaches_edge(const FieldOfViewFit& fit) {
  return fit.fitted.model && fit.fitted.model->reaches_all && fit.score.statistics.coverage.unrepresentable <= kVeryEdge;
}

/// The fit without the coefficient that may make the image radius shrink (bends_back()). The class computes it when it is first
/// needed. There is no such fit if the model has no such coefficient, or the options hold the coefficient at a value or away
/// from 0.
class PlainerFit {
 public:
  explicit PlainerFit(const FitTask& task) : task_(task), coefficient_(bends_back(task.target.id)) {
    const auto is_held = [this](const ParameterRange& range) {
      return range.parameter == *coefficient_ && (range.lower == range.upper || range.lower > 0.0 || range.upper < 0.0);
    };
    if (coefficient_ && std::ranges::any_of(task.options.ranges, is_held)) coefficient_.reset();
  }

  /// True if the fit without the coefficient covers a smaller angle than `fit` and has a smaller rms inside that angle.
  bool is_better_than(const FieldOfViewFit& fit) {
    // A plainer fit that covers a smaller angle has an rms close to its limit of 1 px. A fit with an rms of
    // at most kAlwaysBetterPx is better.
    constexpr double kAlwaysBetterPx = 0.5;
    if (!coefficient_ || fit.score.statistics.error.rms <= kAlwaysBetterPx) return false;
    if (!plainer_) compute();
    if (!plainer_->fitted.model || plainer_->fitted.max_angle_rad >= fit.fitted.max_angle_rad) return false;
    const Scorer inside(task_.camera.model, &fit.fitted.model->model, nullptr, task_.field_of_view,
                        plainer_->fitted.max_angle_rad);
    return score_on_lattice(inside).statistics.error.rms > plainer_->score.statistics.error.rms;
  }

  /// The time of the fit; 0 if it was not needed.
  [[nodiscard]] Micros time() const { return plainer_ ? plainer_->time : Micros{}; }

 private:
  void compute() {
    ConvertOptions options = task_.options;
    options.ranges.push_back({*coefficient_, 0.0, 0.0});
    plainer_ = fit_field_of_view({task_.camera, task_.target, options, task_.field_of_view, task_.centre});
  }

  const FitTask& task_;
  std::optional<ParameterId> coefficient_;  ///< nullopt if there is no fit without it.
  std::optional<FieldOfViewFit> plainer_;
};

/// True if the fit describes the field of view, up to the fit's angle, under the conditions in fit_field_of_view.h.
bool describes(const FitTask& task, const FieldOfViewFit& fit, PlainerFit& plainer) {
  constexpr double kMaxRmsPx = 1.0;
  if (!reaches_edge(fit)) return false;
  return !is_perspective(task.target.id) || (fit.rms_px <= kMaxRmsPx && !plainer.is_better_than(fit));
}

/// The fit up to the given angle [deg] from the axis, scored inside this angle.
FieldOfViewFit fit_up_to(const FitTask& task, double degrees) {
  FieldOfView narrower = task.field_of_view;
  narrower.max_angle_rad = std::min(narrower.max_angle_rad, degrees * kRadiansPerDegree);
  FieldOfViewFit result = fit_and_score({task.camera, task.target, task.options, narrower, task.centre});
  result.fitted.max_angle_rad = narrower.max_angle_rad;
  return result;
}

/// Returns the fit up to the largest angle below `below_rad` that the target describes. Tries multiples of 5 degrees downwards,
/// then bisects to 1 degree. If the target describes none of the multiples, returns the fit up to the largest multiple for
/// which it has a pixel for every ray. If there is none either, the result has no model.
FieldOfViewFit fit_largest_angle(const FitTask& task, double below_rad, PlainerFit& plainer) {
  constexpr int kNarrowestDeg = 5;
  constexpr int kStepDeg = 5;
  const int below = static_cast<int>(std::ceil(below_rad / kRadiansPerDegree - 1e-9));
  FieldOfViewFit best;
  Micros time{};
  const auto try_out = [&](int degrees) {
    FieldOfViewFit narrower = fit_up_to(task, degrees);
    time += narrower.time;
    return narrower;
  };
  for (int good = (below - 1) / kStepDeg * kStepDeg; good >= kNarrowestDeg; good -= kStepDeg) {
    FieldOfViewFit narrower = try_out(good);
    if (too_few(narrower.fitted.samples, task.target)) break;
    if (!describes(task, narrower, plainer)) {
      if (!best.fitted.model && reaches_edge(narrower)) best = std::move(narrower);
      continue;
    }
    best = std::move(narrower);
    for (int bad = std::min(good + kStepDeg, below); bad - good > 1;) {
      const int between = (good + bad) / 2;
      FieldOfViewFit wider = try_out(between);
      const bool is_good = describes(task, wider, plainer);
      (is_good ? good : bad) = between;
      if (is_good) best = std::move(wider);
    }
    break;
  }
  best.time = time;
  return best;
}

}  // namespace

bool too_few(std::size_t samples, const ModelInfo& target) { return 2 * samples < target.parameters.size(); }

FieldOfViewFit fit_field_of_view(const FitTask& task) {
  const double angle = task.field_of_view.max_angle_rad;
  const bool perspective = is_perspective(task.target.id);
  PlainerFit plainer(task);
  FieldOfViewFit result;
  if (!perspective || angle < kRightAngle) {
    result = fit_and_score(task);
    if (too_few(result.fitted.samples, task.target) || describes(task, result, plainer)) {
      result.time += plainer.time();
      return result;
    }
  }
  if (!task.options.reduce_angle) {
    result.fitted.model.reset();
    return result;
  }
  FieldOfViewFit narrower = fit_largest_angle(task, perspective ? std::min(angle, kRightAngle) : angle, plainer);
  const Micros time = result.time + narrower.time + plainer.time();
  if (narrower.fitted.model && (!reaches_edge(result) || describes(task, narrower, plainer))) {
    result = std::move(narrower);
  } else if (!result.fitted.model) {
    // For a perspective model and a field of view beyond 90 degrees: the fit to the samples in front of the camera.
    result = fit_and_score(task);
  }
  result.time = time;
  if (const std::optional<FittedModel>& model = result.fitted.model) {
    // A fit up to a smaller angle was scored with a field of view up to that angle. Its report is about the whole field of
    // view.
    result.score =
        score_on_lattice({task.camera.model, &model->model, nullptr, task.field_of_view, result.fitted.max_angle_rad});
    result.rms_px = rms_of(task, result.fitted, result.score.statistics);
  }
  return result;
}

}  // namespace fca::internal
