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
constexpr double kAhead = std::numbers::pi / 2.0;

/// Fits the target to about `count` samples of the field of view. Starts from `coarser`, a fit to fewer samples, unless it is
/// null.
SampledFit fit(const FitTask& task, int count, const FittedModel* coarser = nullptr) {
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

/// The larger of the rms over the image and the rms on the fit's samples, divided by the smaller one; 1 if the difference is
/// below 1e-6 px. A model that bends faster than the samples are dense (rational beyond 70 degrees) can be twice as bad over
/// the image. One that is better over the image was fitted to a few samples that happen to be the worst.
double rms_ratio_to_samples(double rms_px, const FittedModel& fitted) {
  constexpr double kNobodySees = 1e-6;  // px
  const auto [less, more] = std::minmax(rms_px, fitted.rms_px);
  return !fitted.reaches_all || more <= less + kNobodySees ? 1.0 : more / less;
}

/// The rms over the image [px], with the weights that the fit minimises.
double rms_of(const FitTask& task, const SampledFit& fitted, const ErrorStatistics& statistics) {
  if (has_equal_weights(task.options.weight)) return statistics.error.rms;
  return weighted_rms(task.options.weight, task.camera.model, fitted.model->model, task.field_of_view, fitted.max_angle_rad);
}

/// Fits the target to the field of view and scores it over the image. Repeats that on more samples while it helps. A fit that
/// does not reach every sample is not scored.
FieldOfViewFit fit_and_score(const FitTask& task) {
  constexpr int kMostDoublings = 3;
  constexpr double kAlike = 1.01;  // ratio of rms; the lattice is no more exact than that
  constexpr double kVeryUnlike = 1.2;
  constexpr double kHelps = 0.999;
  constexpr double kNobodySees = 1e-4;  // px
  FieldOfViewFit result;
  for (int doubling = 0; doubling <= kMostDoublings; ++doubling) {
    const bool is_first = doubling == 0;
    const Clock::time_point start = Clock::now();
    SampledFit finer = fit(task, task.options.samples << doubling, is_first ? nullptr : &*result.fitted.model);
    result.time += Clock::now() - start;
    if (!finer.model || !finer.model->reaches_all) {
      if (is_first) result.fitted = std::move(finer);
      break;
    }
    Score score = score_on_lattice({task.camera.model, &finer.model->model, nullptr, task.field_of_view, finer.max_angle_rad});
    const ErrorStatistics& statistics = score.statistics;
    const ErrorStatistics& before = result.score.statistics;
    const double rms_px = rms_of(task, finer, statistics);
    const bool helps =
        is_first || statistics.coverage.scored > before.coverage.scored + 1e-3 || rms_px < kHelps * result.rms_px;
    const double unlike = rms_ratio_to_samples(rms_px, *finer.model);
    const bool misses_edge = statistics.coverage.unrepresentable > kVeryEdge;
    if (helps) {
      result.fitted = std::move(finer);
      result.score = std::move(score);
      result.rms_px = rms_px;
    }
    // A fit places poles where they cost nothing at the samples, and the errors at samples and image may agree by chance: such
    // a model is always fitted a second time.
    if (is_first && has_poles(task.target.id) && rms_px > kNobodySees) continue;
    if (unlike <= (helps ? kAlike : kVeryUnlike) && !(helps && misses_edge)) break;
  }
  return result;
}

/// True if the model has a pixel for every ray of the field of view except at its very edge (kVeryEdge). Its image radius then
/// grows up to there, since a model's domain ends where the radius stops growing.
bool reaches(const FieldOfViewFit& fit) {
  return fit.fitted.model && fit.fitted.model->reaches_all && fit.score.statistics.coverage.unrepresentable <= kVeryEdge;
}

/// The fit without the coefficient that may bend the image radius back. It is made when first needed.
class PlainerFit {
 public:
  explicit PlainerFit(const FitTask& task) : task_(task), coefficient_(bends_back(task.target.id)) {
    const auto is_held = [this](const ParameterRange& range) {
      return range.parameter == *coefficient_ && (range.lower == range.upper || range.lower > 0.0 || range.upper < 0.0);
    };
    if (coefficient_ && std::ranges::any_of(task.options.ranges, is_held)) coefficient_.reset();
  }

  /// True if the fit without the coefficient covers a smaller angle and is better inside it than `fit`, which covers more.
  bool is_better_than(const FieldOfViewFit& fit) {
    // px. A plainer fit that ends before the whole field of view has nearly reached its limit of 1 px.
    constexpr double kNeverWorse = 0.5;
    if (!coefficient_ || fit.score.statistics.error.rms <= kNeverWorse) return false;
    if (!made_) make();
    if (!made_->fitted.model || made_->fitted.max_angle_rad >= fit.fitted.max_angle_rad) return false;
    const Scorer inside(task_.camera.model, &fit.fitted.model->model, nullptr, task_.field_of_view,
                        made_->fitted.max_angle_rad);
    return score_on_lattice(inside).statistics.error.rms > made_->score.statistics.error.rms;
  }

  [[nodiscard]] Micros time() const { return made_ ? made_->time : Micros{}; }

 private:
  void make() {
    ConvertOptions options = task_.options;
    options.ranges.push_back({*coefficient_, 0.0, 0.0});
    made_ = fit_field_of_view({task_.camera, task_.target, options, task_.field_of_view, task_.centre});
  }

  const FitTask& task_;
  std::optional<ParameterId> coefficient_;
  std::optional<FieldOfViewFit> made_;
};

/// True if the fit describes its field of view, or its angle, by the rule in fit_field_of_view.h.
bool describes(const FitTask& task, const FieldOfViewFit& fit, PlainerFit& plainer) {
  constexpr double kLimitRms = 1.0;  // px
  if (!reaches(fit)) return false;
  return !is_perspective(task.target.id) || (fit.rms_px <= kLimitRms && !plainer.is_better_than(fit));
}

/// The fit up to that angle from the axis, scored inside it.
FieldOfViewFit fit_up_to(const FitTask& task, double degrees) {
  FieldOfView narrower = task.field_of_view;
  narrower.max_angle_rad = std::min(narrower.max_angle_rad, degrees * kRadiansPerDegree);
  FieldOfViewFit result = fit_and_score({task.camera, task.target, task.options, narrower, task.centre});
  result.fitted.max_angle_rad = narrower.max_angle_rad;
  return result;
}

/// The fit up to the largest angle below `below_rad` that the target describes, searched for in steps of 5 degrees, then to
/// 1 degree. If there is none, the fit up to the largest angle of the steps for which it has all pixels. If there is none
/// either, the result has no model.
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
      if (!best.fitted.model && reaches(narrower)) best = std::move(narrower);
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
  if (!perspective || angle < kAhead) {
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
  FieldOfViewFit narrower = fit_largest_angle(task, perspective ? std::min(angle, kAhead) : angle, plainer);
  const Micros time = result.time + narrower.time + plainer.time();
  if (narrower.fitted.model && (!reaches(result) || describes(task, narrower, plainer))) {
    result = std::move(narrower);
  } else if (!result.fitted.model) {
    result = fit_and_score(task);  // a pinhole-like model: to the part of the field of view in front of the camera
  }
  result.time = time;
  if (const std::optional<FittedModel>& model = result.fitted.model) {
    // A fit up to a smaller angle was scored inside it only; the reported error is that over the whole field of view.
    result.score =
        score_on_lattice({task.camera.model, &model->model, nullptr, task.field_of_view, result.fitted.max_angle_rad});
    result.rms_px = rms_of(task, result.fitted, result.score.statistics);
  }
  return result;
}

}  // namespace fca::internal
