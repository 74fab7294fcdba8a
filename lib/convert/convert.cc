// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/convert.h>

#include "exact.h"
#include "fit_model.h"
#include "judge_maximum.h"
#include "judge_stages.h"
#include "minimax.h"

#include <fca/convert/domain.h>
#include <fca/convert/judge.h>
#include <fca/convert/reach.h>
#include <fca/convert/sample.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace fca {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

/// What the steps of one conversion hand to each other.
struct Job {
  const Camera& camera;
  const ModelInfo& target;
  const ConvertOptions& options;
  Domain domain;
  LensCentre centre;  ///< Of the source.
};

/// A fit, the number of samples it was made on, and the angle up to which it counts.
struct SampledFit {
  std::optional<internal::FittedModel> model;
  std::size_t samples = 0;
  double reach_rad = std::numbers::pi;
};

bool too_few(std::size_t samples, const Job& job) { return 2 * samples < job.target.parameters.size(); }

/// Fits the target to about `count` samples of the domain: from its own starts, or where one to fewer samples ended.
SampledFit fit(const Job& job, const Domain& domain, int count, const SampledFit* coarser = nullptr) {
  const std::vector<Correspondence> samples = sample(job.camera.model, domain, count);
  SampledFit result;
  result.samples = samples.size();
  if (!too_few(samples.size(), job)) {
    result.model = coarser != nullptr ? internal::fit_from(coarser->model->model, samples, job.options.ranges)
                                      : internal::fit_model(job.target.id, samples, job.centre, job.options.ranges);
  }
  return result;
}

/// The largest cone, in steps of 5 degrees, on which the target reaches every ray and stays under 1 px rms; failing that, the
/// largest on which it reaches every ray.
SampledFit fit_largest_cone(const Job& job, int count) {
  constexpr double kLimitRms = 1.0;  // px
  constexpr int kWidestDeg = 85;
  constexpr int kNarrowestDeg = 20;
  constexpr int kStepDeg = 5;
  SampledFit widest_reaching;
  for (int degrees = kWidestDeg; degrees >= kNarrowestDeg; degrees -= kStepDeg) {
    const double angle = degrees * kRadiansPerDegree;
    if (angle >= job.domain.max_angle_rad) continue;
    Domain cone = job.domain;
    cone.max_angle_rad = angle;
    SampledFit candidate = fit(job, cone, count);
    if (too_few(candidate.samples, job)) break;
    if (!candidate.model || !candidate.model->reaches_all || max_angle(candidate.model->model) < angle) continue;
    candidate.reach_rad = angle;
    if (candidate.model->rms_px <= kLimitRms) return candidate;
    if (!widest_reaching.model) widest_reaching = std::move(candidate);
  }
  return widest_reaching;
}

void warn_of_cone(const Job& job, double cone_rad, Diagnostics& diagnostics) {
  const auto degrees = std::to_string(std::lround(cone_rad / kRadiansPerDegree));
  diagnostics.warning("target-cannot-reach",
                      job.camera.name + ": " + std::string(job.target.id) +
                          " cannot describe this lens as far as the domain goes; it was fitted inside " + degrees +
                          " deg from the axis, is scored there, and gives wrong pixels or none beyond",
                      {},
                      "models that reach further: " + std::string(job.target.id == "kb4" ? "" : "kb4, ") +
                          "ocamcalib, woodscape; fca-io models FILE compares all");
}

/// The fit to the whole domain or, if the target cannot describe that, to the largest cone.
SampledFit fit_as_far_as_possible(const Job& job, int count, const SampledFit* coarser) {
  const bool same_domain = coarser != nullptr && coarser->reach_rad >= std::numbers::pi;
  SampledFit fitted = fit(job, job.domain, count, same_domain ? coarser : nullptr);
  if (!too_few(fitted.samples, job) && (!fitted.model || !fitted.model->reaches_all)) {
    if (SampledFit narrower = fit_largest_cone(job, count); narrower.model) return narrower;
  }
  return fitted;
}

/// Everything the report says of a model that counts up to that angle, from what the lattice says of it.
Judgement final_judgement(const Job& job, const internal::Scorer& scorer, internal::Score score) {
  if (job.options.every_pixel) score = internal::score_every_pixel(scorer);
  internal::find_maximum(scorer, score.worst, job.options.bound, score.judgement);
  return std::move(score.judgement);
}

internal::Scorer scorer_of(const Job& job, const CameraModel& model, double reach_rad) {
  return {job.camera.model, &model, nullptr, job.domain, reach_rad};
}

/// Does nothing beyond double's rounding separate the two models? Then no fit is reported as one.
std::optional<Conversion> exact_conversion(const Job& job) {
  const std::optional<CameraModel> model = internal::convert_exactly(job.camera.model, job.target.id);
  if (!model || !within(*model, job.options.ranges) || !validate(*model).empty()) return std::nullopt;
  Conversion conversion{job.camera, {}};
  conversion.camera.model = *model;
  conversion.report.exact = true;
  const internal::Scorer scorer = scorer_of(job, *model, std::numbers::pi);
  conversion.report.judgement = final_judgement(job, scorer, internal::score_on_lattice(scorer));
  return conversion;
}

/// How many times worse the model is over the image than on the samples of its fit; 1 if nobody sees the difference. One that
/// bends faster than they lie (rational beyond 70 degrees) can be twice as bad; a few percent are the image's border, where the
/// judge counts whole pixels.
double worse_between_samples(const Judgement& judgement, const internal::FittedModel& fitted) {
  constexpr double kNobodySees = 1e-6;  // px
  if (!fitted.reaches_all || judgement.error.rms <= fitted.rms_px + kNobodySees) return 1.0;
  return judgement.error.rms / fitted.rms_px;
}

/// Replaces a least-squares fit by the camera near it whose largest error is smallest, if that is smaller and reaches as much.
void cut_worst_pixel(const Job& job, double reach_rad, Conversion& conversion) {
  using Clock = std::chrono::steady_clock;
  ConversionReport& report = conversion.report;
  CameraModel& model = conversion.camera.model;
  const Judgement& before = report.judgement;
  report.objective = Objective::kMax;
  report.rms_fit = {before.error.rms, before.error.max, true};
  const Clock::time_point start = Clock::now();
  internal::MinimaxFit fit = internal::fit_largest_error(job.camera.model, model, job.domain, reach_rad, job.options.ranges);
  report.fit.time_us += std::chrono::duration<double, std::micro>(Clock::now() - start).count();
  report.fit.iterations += fit.iterations;
  if (!validate(fit.model).empty()) return;
  const internal::Scorer scorer = scorer_of(job, fit.model, reach_rad);
  Judgement after = final_judgement(job, scorer, internal::score_on_lattice(scorer));
  if (!(after.error.max < before.error.max && after.coverage.scored >= before.coverage.scored)) return;
  report.rms_fit->kept = false;
  report.judgement = std::move(after);
  report.at_bound = std::move(fit.at_bound);
  model = fit.model;
}

/// The conversion by a fit, on twice as many samples while it is worse between them and that helps, and its judgement.
std::optional<Conversion> fitted_conversion(const Job& job, Diagnostics& diagnostics) {
  using Clock = std::chrono::steady_clock;
  constexpr int kMostDoublings = 3;
  Clock::duration time{};
  constexpr double kBorder = 1.03;
  constexpr double kMuchWorse = 1.2;
  constexpr double kHelps = 0.99;
  SampledFit fitted;
  internal::Score score;
  for (int doubling = 0; doubling <= kMostDoublings; ++doubling) {
    const Clock::time_point start = Clock::now();
    SampledFit finer = fit_as_far_as_possible(job, job.options.samples << doubling, doubling > 0 ? &fitted : nullptr);
    time += Clock::now() - start;
    if (!finer.model) {
      if (doubling == 0) fitted = std::move(finer);
      break;
    }
    internal::Score finer_score = internal::score_on_lattice(scorer_of(job, finer.model->model, finer.reach_rad));
    const Judgement& judgement = finer_score.judgement;
    const bool helps = doubling == 0 || judgement.coverage.scored > score.judgement.coverage.scored + 1e-3 ||
                       judgement.error.rms < kHelps * score.judgement.error.rms;
    const double worse = worse_between_samples(judgement, *finer.model);
    if (helps) {
      fitted = std::move(finer);
      score = std::move(finer_score);
    }
    if (worse <= (helps ? kBorder : kMuchWorse)) break;
  }
  if (too_few(fitted.samples, job)) {
    diagnostics.error("domain-too-small",
                      job.camera.name + ": too few pixels of the image have a ray to fit " + std::string(job.target.id));
    return std::nullopt;
  }
  if (!fitted.model) {
    diagnostics.error("fit-failed", job.camera.name + ": no " + std::string(job.target.id) + " camera comes near this one");
    return std::nullopt;
  }
  if (fitted.reach_rad < std::numbers::pi) warn_of_cone(job, fitted.reach_rad, diagnostics);
  Conversion conversion{job.camera, {}};
  conversion.camera.model = fitted.model->model;
  conversion.report.judgement = final_judgement(job, scorer_of(job, fitted.model->model, fitted.reach_rad), std::move(score));
  conversion.report.fit = {static_cast<int>(fitted.samples), fitted.model->iterations,
                           std::chrono::duration<double, std::micro>(time).count()};
  conversion.report.at_bound = fitted.model->at_bound;
  if (job.options.objective == Objective::kMax) cut_worst_pixel(job, fitted.reach_rad, conversion);
  return conversion;
}

/// Are ranges and samples what a fit can work with?
bool usable(const ConvertOptions& options, const ModelInfo& target, Diagnostics& diagnostics) {
  constexpr int kMostSamples = 100'000;
  if (options.samples < 1 || options.samples > kMostSamples) {
    diagnostics.error("samples-invalid", "a fit wants between 1 and " + std::to_string(kMostSamples) + " samples");
    return false;
  }
  for (const ParameterRange& range : options.ranges) {
    if (std::ranges::find(target.parameters, range.parameter, &Parameter::name) == target.parameters.end()) {
      diagnostics.error("unknown-parameter",
                        std::string(target.id) + " has no parameter '" + std::string(range.parameter) + "'");
      return false;
    }
    if (!(range.lower <= range.upper)) {
      diagnostics.error("range-empty", "the range of " + std::string(range.parameter) + " holds no number");
      return false;
    }
  }
  return true;
}

}  // namespace

bool within(const CameraModel& model, std::span<const ParameterRange> ranges) {
  return std::ranges::all_of(ranges, [&model](const ParameterRange& range) {
    const std::optional<double> value = parameter(model, range.parameter);
    return !value || (*value >= range.lower && *value <= range.upper);
  });
}

std::optional<Conversion> convert(const Camera& camera, const ConvertOptions& options, Diagnostics& diagnostics) {
  const ModelInfo* target = find_model(options.model);
  if (target == nullptr) {
    diagnostics.error("unknown-model", "there is no camera model '" + options.model + "'");
    return std::nullopt;
  }
  if (!usable(options, *target, diagnostics)) return std::nullopt;
  std::optional<Domain> domain = domain_of(camera, options.max_angle_rad, diagnostics);
  if (!domain) return std::nullopt;
  const LensCentre centre{central_focal_lengths(camera.model), principal_point(camera.model)};
  const Job job{camera, *target, options, *std::move(domain), centre};

  std::optional<Conversion> conversion = exact_conversion(job);
  if (!conversion) conversion = fitted_conversion(job, diagnostics);
  if (!conversion) return std::nullopt;
  conversion->report.from_model = model_info(camera.model).id;
  conversion->report.to_model = target->id;
  if (options.reach) conversion->report.reach = reach_table(camera, options, diagnostics);
  if (!(conversion->report.judgement.coverage.scored > 0.0)) {
    diagnostics.error("nothing-to-compare",
                      camera.name + ": no part of the image could be compared with " + std::string(target->id));
    return std::nullopt;
  }
  return conversion;
}

}  // namespace fca
