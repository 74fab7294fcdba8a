// SPDX-License-Identifier: BSD-3-Clause
#include "fit_domain.h"

#include <fca/convert/sample.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fca::internal {

namespace {

using Clock = std::chrono::steady_clock;
using Micros = std::chrono::duration<double, std::micro>;

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

/// A cone is worth more than the whole domain if it stays below this and the whole does not.
constexpr double kLimitRms = 1.0;  // px

constexpr double kNearlyAhead = 85.0 * kRadiansPerDegree;  // here a plane is ten times as large as its distance

/// Fits the target to about `count` samples of the domain: from its own starts, or where one to fewer samples ended.
SampledFit fit(const FitTask& task, const Domain& domain, int count, const FittedModel* coarser = nullptr) {
  const std::vector<Correspondence> samples = sample(task.camera.model, domain, count);
  SampledFit result;
  result.samples = samples.size();
  if (!too_few(samples.size(), task.target)) {
    result.model = coarser != nullptr ? fit_from(coarser->model, samples, task.options.ranges)
                                      : fit_model(task.target.id, samples, task.centre, task.options.ranges);
  }
  return result;
}

/// The part of the domain within that angle.
Domain cone_of(const Domain& domain, double angle_rad) {
  Domain cone = domain;
  cone.max_angle_rad = std::min(domain.max_angle_rad, angle_rad);
  return cone;
}

/// Does the model reach that angle, and not the samples alone?
bool reaches(const FittedModel& fitted, double angle_rad) {
  constexpr double kRounding = 1e-9;
  return fitted.reaches_all && max_angle(fitted.model) >= (1.0 - kRounding) * angle_rad;
}

/// The fit on the cone of that angle; no model where the target does not reach every ray of it.
SampledFit fit_cone(const FitTask& task, int count, double angle) {
  SampledFit result = fit(task, cone_of(task.domain, angle), count);
  result.reach_rad = angle;
  if (result.model && !reaches(*result.model, angle)) result.model.reset();
  return result;
}

/// The largest cone inside `below_rad` on which the target reaches every ray and stays under the limit, found in steps of 5
/// degrees and to a degree; failing that, the largest of the steps on which it reaches every ray.
SampledFit fit_largest_cone(const FitTask& task, int count, double below_rad) {
  constexpr int kNarrowestDeg = 20;
  constexpr int kStepDeg = 5;
  const auto is_good = [](const SampledFit& cone) { return cone.model && cone.model->rms_px <= kLimitRms; };
  const double below = below_rad / kRadiansPerDegree;
  SampledFit widest_reaching;
  for (int degrees = kStepDeg * static_cast<int>(std::ceil(below / kStepDeg) - 1); degrees >= kNarrowestDeg;
       degrees -= kStepDeg) {
    SampledFit cone = fit_cone(task, count, degrees * kRadiansPerDegree);
    if (too_few(cone.samples, task.target)) break;
    if (!is_good(cone)) {
      if (cone.model && !widest_reaching.model) widest_reaching = std::move(cone);
      continue;
    }
    // Near 90 degrees a plane is good on the samples and wild between them.
    if (sees_ahead_only(task.target.id) && degrees * kRadiansPerDegree > kNearlyAhead - 1e-9) return cone;
    int good = degrees;
    for (int bad = std::min(degrees + kStepDeg, static_cast<int>(std::ceil(below))); bad - good > 1;) {
      const int between = (good + bad) / 2;
      SampledFit wider = fit_cone(task, count, between * kRadiansPerDegree);
      (is_good(wider) ? good : bad) = between;
      if (is_good(wider)) cone = std::move(wider);
    }
    return cone;
  }
  return widest_reaching;
}

/// The fit to the whole domain or, if the target cannot describe that, to the largest cone.
SampledFit fit_as_far_as_possible(const FitTask& task, int count) {
  constexpr double kAhead = std::numbers::pi / 2.0;
  const bool ahead_only = sees_ahead_only(task.target.id);
  const double angle = task.domain.max_angle_rad;
  if (ahead_only && angle >= kAhead) {
    if (SampledFit cone = fit_largest_cone(task, count, kAhead); cone.model) return cone;
  }
  SampledFit whole = fit(task, task.domain, count);
  if (too_few(whole.samples, task.target)) return whole;
  const bool reaches_all = whole.model && whole.model->reaches_all;
  if (reaches_all) {
    // What reaches all only because it must may be next to useless.
    const bool forced = whole.model->second_best || (ahead_only && angle > kNearlyAhead);
    if (!forced || whole.model->rms_px <= kLimitRms) return whole;
  }
  SampledFit cone = fit_largest_cone(task, count, std::min(angle, ahead_only ? kAhead : angle));
  const bool cone_is_better = cone.model && (!reaches_all || cone.model->rms_px <= kLimitRms);
  return cone_is_better ? cone : whole;
}

/// The same on more samples, from where the fit to fewer ended; a narrower cone where it turns out not to reach the edge.
SampledFit refine(const FitTask& task, int count, const SampledFit& coarser) {
  const Domain domain = cone_of(task.domain, coarser.reach_rad);
  SampledFit finer = fit(task, domain, count, &*coarser.model);
  const bool is_cone = coarser.reach_rad < std::numbers::pi;
  if (finer.model && (is_cone ? reaches(*finer.model, domain.max_angle_rad) : finer.model->reaches_all)) {
    finer.reach_rad = coarser.reach_rad;
    return finer;
  }
  if (SampledFit narrower = fit_largest_cone(task, count, domain.max_angle_rad); narrower.model) return narrower;
  return finer;
}

/// How many times worse the model is over the image than on the samples of its fit; 1 if nobody sees the difference. One that
/// bends faster than they lie (rational beyond 70 degrees) can be twice as bad; a few percent are the image's border, where the
/// judge counts whole pixels.
double worse_between_samples(const Judgement& judgement, const FittedModel& fitted) {
  constexpr double kNobodySees = 1e-6;  // px
  if (!fitted.reaches_all || judgement.error.rms <= fitted.rms_px + kNobodySees) return 1.0;
  return judgement.error.rms / fitted.rms_px;
}

/// From a fit to few samples to one whose error is that of the image: on more samples, while that helps. How many times worse
/// it is between its samples after all goes to `worse_of_result`.
DomainFit refine_all(const FitTask& task, const SampledFit& first, Micros time, double& worse_of_result) {
  constexpr int kMostDoublings = 3;
  constexpr double kBorder = 1.03;
  constexpr double kMuchWorse = 1.2;
  constexpr double kHelps = 0.99;
  DomainFit result;
  result.time = time;
  worse_of_result = 1.0;
  for (int doubling = 0; doubling <= kMostDoublings; ++doubling) {
    const Clock::time_point start = Clock::now();
    SampledFit finer = doubling == 0 ? first : refine(task, task.options.samples << doubling, result.fitted);
    result.time += Clock::now() - start;
    if (!finer.model) {
      if (doubling == 0) result.fitted = std::move(finer);
      break;
    }
    Score score = score_on_lattice({task.camera.model, &finer.model->model, nullptr, task.domain, finer.reach_rad});
    const Judgement& judgement = score.judgement;
    const Judgement& before = result.score.judgement;
    const bool helps = doubling == 0 || judgement.coverage.scored > before.coverage.scored + 1e-3 ||
                       judgement.error.rms < kHelps * before.error.rms;
    const double worse = worse_between_samples(judgement, *finer.model);
    if (helps) {
      result.fitted = std::move(finer);
      result.score = std::move(score);
      worse_of_result = worse;
    }
    if (worse <= (helps ? kBorder : kMuchWorse)) break;
  }
  return result;
}

}  // namespace

bool too_few(std::size_t samples, const ModelInfo& target) { return 2 * samples < target.parameters.size(); }

DomainFit fit_domain(const FitTask& task) {
  constexpr double kWild = 2.0;
  double worse = 1.0;
  Clock::time_point start = Clock::now();
  const SampledFit first = fit_as_far_as_possible(task, task.options.samples);
  DomainFit result = refine_all(task, first, Clock::now() - start, worse);
  const bool is_whole = result.fitted.reach_rad >= std::numbers::pi;
  if (!is_whole || worse <= kWild || result.score.judgement.error.rms <= kLimitRms) return result;
  // No number of samples lies close enough to the edge of a plane, which is infinite at 90 degrees: a cone, if there is a good
  // one.
  start = Clock::now();
  const SampledFit cone = fit_largest_cone(task, task.options.samples, task.domain.max_angle_rad);
  if (!cone.model || cone.model->rms_px > kLimitRms) return result;
  return refine_all(task, cone, result.time + (Clock::now() - start), worse);
}

}  // namespace fca::internal
