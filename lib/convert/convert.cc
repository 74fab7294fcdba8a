// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/convert.h>

#include "exact.h"
#include "fit_domain.h"
#include "judge_stages.h"
#include "minimax.h"

#include <fca/convert/domain.h>
#include <fca/convert/judge.h>
#include <fca/convert/reach.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace fca {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

using internal::FitTask;

void warn_of_cone(const FitTask& task, double cone_rad, Diagnostics& diagnostics) {
  const auto degrees = std::to_string(std::lround(cone_rad / kRadiansPerDegree));
  diagnostics.warning("target-cannot-reach",
                      task.camera.name + ": " + std::string(task.target.id) +
                          " cannot describe this lens as far as the domain goes; it was fitted inside " + degrees +
                          " deg from the axis, is scored there, and gives wrong pixels or none beyond",
                      {}, "another model may reach further: fca-io models FILE compares all models");
}

/// A model of a plane goes on to 90 degrees: where a part of the image has no ray, its distortion folds.
void warn_of_fold(const Camera& camera, const Coverage& coverage, Diagnostics& diagnostics) {
  constexpr double kCorners = 1e-3;
  if (!sees_ahead_only(model_info(camera.model).id) || coverage.outside_lens < kCorners) return;
  const auto degrees = std::to_string(std::lround(max_angle(camera.model) / kRadiansPerDegree));
  const auto tenths = std::lround(1000.0 * coverage.outside_lens);
  const std::string percent = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  diagnostics.warning("folds-inside-image",
                      camera.name + ": its distortion folds at " + degrees +
                          " deg from the axis, inside the image: " + percent + " % of the image has no ray",
                      {},
                      "calibrate anew with observations up to the corners, or with a model for wide lenses (kb4, ds, eucm)");
}

/// What no lens has, but arithmetic can convert all the same. `check` asks for more; this is what cannot be meant.
void warn_of_odd_camera(const Camera& camera, const ImageSize& size, Diagnostics& diagnostics) {
  constexpr double kNoSensor = 2.0;
  const auto rounded = [](double px) { return std::to_string(std::lround(px)); };
  const auto [f_u, f_v] = central_focal_lengths(camera.model);
  if (std::max(f_u, f_v) > kNoSensor * std::min(f_u, f_v)) {
    diagnostics.warning("focal-lengths-differ",
                        camera.name + ": the focal lengths along u and v, " + rounded(f_u) + " and " + rounded(f_v) +
                            " px, differ more than the sides of any sensor's pixels do",
                        {}, "compare both with the calibration's result");
  }
  const auto [u, v] = principal_point(camera.model);
  if (!(u >= -0.5 && u <= size.width - 0.5 && v >= -0.5 && v <= size.height - 0.5)) {
    diagnostics.warning("centre-outside",
                        camera.name + ": the principal point (" + rounded(u) + ", " + rounded(v) + ") lies outside the " +
                            std::to_string(size.width) + " x " + std::to_string(size.height) + " image",
                        {}, "right for a part cut out of a larger image; else compare it with the calibration's result");
  }
}

/// Everything the report says of a model, from what the lattice says of it.
Judgement final_judgement(const FitTask& task, const internal::Scorer& scorer, internal::Score lattice) {
  return internal::judge_all(scorer, std::move(lattice), {task.options.every_pixel, task.options.bound});
}

/// The angle beyond which a model that counts up to `reach_rad` is not scored.
double scored_to_deg(const FitTask& task, const CameraModel& model, double reach_rad) {
  return std::min({task.domain.max_angle_rad, reach_rad, max_angle(model)}) / kRadiansPerDegree;
}

internal::Scorer scorer_of(const FitTask& task, const CameraModel& model, double reach_rad) {
  return {task.camera.model, &model, nullptr, task.domain, reach_rad};
}

/// Does nothing beyond double's rounding separate the two models? Then no fit is reported as one.
std::optional<Conversion> exact_conversion(const FitTask& task) {
  const std::optional<CameraModel> model = internal::convert_exactly(task.camera.model, task.target.id);
  if (!model || !within(*model, task.options.ranges) || !validate(*model).empty()) return std::nullopt;
  Conversion conversion{task.camera, {}};
  conversion.camera.model = *model;
  conversion.report.exact = true;
  const internal::Scorer scorer = scorer_of(task, *model, std::numbers::pi);
  conversion.report.judgement = final_judgement(task, scorer, internal::score_on_lattice(scorer));
  conversion.report.scored_to_deg = scored_to_deg(task, *model, std::numbers::pi);
  return conversion;
}

/// Replaces a least-squares fit by the camera near it whose largest error is smallest, if that is smaller and reaches as much.
void cut_worst_pixel(const FitTask& task, double reach_rad, Conversion& conversion) {
  using Clock = std::chrono::steady_clock;
  ConversionReport& report = conversion.report;
  CameraModel& model = conversion.camera.model;
  const Judgement& before = report.judgement;
  report.objective = Objective::kMax;
  report.rms_fit = {before.error.rms, before.error.max, true};
  const Clock::time_point start = Clock::now();
  internal::MinimaxFit fit = internal::fit_largest_error(task.camera.model, model, task.domain, reach_rad, task.options.ranges);
  report.fit.time_us += std::chrono::duration<double, std::micro>(Clock::now() - start).count();
  report.fit.iterations += fit.iterations;
  if (!validate(fit.model).empty()) return;
  const internal::Scorer scorer = scorer_of(task, fit.model, reach_rad);
  Judgement after = final_judgement(task, scorer, internal::score_on_lattice(scorer));
  if (!(after.error.max < before.error.max && after.coverage.scored >= before.coverage.scored)) return;
  report.rms_fit->kept = false;
  report.judgement = std::move(after);
  report.at_bound = std::move(fit.at_bound);
  model = fit.model;
}

/// The conversion by a fit, and its judgement.
std::optional<Conversion> fitted_conversion(const FitTask& task, Diagnostics& diagnostics) {
  internal::DomainFit found = internal::fit_domain(task);
  const internal::SampledFit& fitted = found.fitted;
  if (internal::too_few(fitted.samples, task.target)) {
    diagnostics.error("domain-too-small",
                      task.camera.name + ": too few pixels of the image have a ray to fit " + std::string(task.target.id));
    return std::nullopt;
  }
  const ImageSize& size = task.domain.size;
  const double pixels = found.score.judgement.coverage.scored * size.width * size.height;
  if (fitted.model && 2.0 * pixels < static_cast<double>(task.target.parameters.size())) {
    diagnostics.error("domain-too-small", task.camera.name + ": too few pixels of the image lie in the domain to fit " +
                                              std::string(task.target.id) + ", however many samples are taken between them");
    return std::nullopt;
  }
  if (!fitted.model) {
    diagnostics.error("fit-failed", task.camera.name + ": no " + std::string(task.target.id) + " camera comes near this one");
    return std::nullopt;
  }
  Conversion conversion{task.camera, {}};
  conversion.report.fitted_to_cone = fitted.reach_rad < std::numbers::pi;
  if (conversion.report.fitted_to_cone) warn_of_cone(task, fitted.reach_rad, diagnostics);
  conversion.camera.model = fitted.model->model;
  const internal::Scorer scorer = scorer_of(task, fitted.model->model, fitted.reach_rad);
  conversion.report.judgement = final_judgement(task, scorer, std::move(found.score));
  conversion.report.fit = {static_cast<int>(fitted.samples), fitted.model->iterations, found.time.count()};
  conversion.report.at_bound = fitted.model->at_bound;
  if (task.options.objective == Objective::kMax) cut_worst_pixel(task, fitted.reach_rad, conversion);
  conversion.report.scored_to_deg = scored_to_deg(task, conversion.camera.model, fitted.reach_rad);
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
    if (std::ranges::find(target.parameters, range.parameter.name(), &Parameter::name) == target.parameters.end()) {
      diagnostics.error("unknown-parameter",
                        std::string(target.id) + " has no parameter '" + std::string(range.parameter.name()) + "'");
      return false;
    }
    if (!(range.lower <= range.upper)) {
      diagnostics.error("range-empty", "the range of " + std::string(range.parameter.name()) + " holds no number");
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
  const std::optional<Domain> domain = domain_of(camera, options.max_angle_rad, diagnostics);
  if (!domain) return std::nullopt;
  warn_of_odd_camera(camera, domain->size, diagnostics);
  const LensCentre centre{central_focal_lengths(camera.model), principal_point(camera.model)};
  const FitTask task{camera, *target, options, *domain, centre};

  std::optional<Conversion> conversion = exact_conversion(task);
  if (!conversion) conversion = fitted_conversion(task, diagnostics);
  if (!conversion) return std::nullopt;
  if (!options.max_angle_rad && !camera.lens_circle) warn_of_fold(camera, conversion->report.judgement.coverage, diagnostics);
  conversion->report.from_model = model_info(camera.model).id;
  conversion->report.to_model = target->id;
  if (options.reach) conversion->report.reach = reach_table(camera, options, conversion->report, diagnostics);
  if (!(conversion->report.judgement.coverage.scored > 0.0)) {
    diagnostics.error("nothing-to-compare",
                      camera.name + ": no part of the image could be compared with " + std::string(target->id));
    return std::nullopt;
  }
  return conversion;
}

}  // namespace fca
