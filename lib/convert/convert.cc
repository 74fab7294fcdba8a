// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/convert.h>

#include "exact.h"
#include "fit_model.h"

#include <fca/convert/domain.h>
#include <fca/convert/judge.h>
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

/// Root mean square of the distances between the samples' pixels and the model's, over those it reaches.
double rms_over(std::span<const Correspondence> samples, const CameraModel& model) {
  double sum = 0.0;
  double weight = 0.0;
  for (const Correspondence& s : samples) {
    const std::optional<Pixel> pixel = project(model, s.ray);
    if (!pixel) continue;
    sum += s.weight * (std::pow((*pixel)[0] - s.pixel[0], 2) + std::pow((*pixel)[1] - s.pixel[1], 2));
    weight += s.weight;
  }
  return weight > 0.0 ? std::sqrt(sum / weight) : 0.0;
}

/// A fit and the number of samples it was made on.
struct SampledFit {
  std::optional<internal::FittedModel> model;
  std::size_t samples = 0;
};

bool too_few(std::size_t samples, const Job& job) { return 2 * samples < job.target.parameters.size(); }

/// Fits the target to samples of the domain. A model that bends faster than the samples lie (rational beyond 70 degrees) can be
/// good on them and bad between: then there are twice as many the next time.
SampledFit fit(const Job& job, const Domain& domain) {
  constexpr int kMostDoublings = 3;
  constexpr double kWorse = 1.02;
  constexpr double kNobodySees = 1e-6;  // px
  SampledFit result;
  std::vector<Correspondence> samples = sample(job.camera.model, domain, job.options.samples);
  for (int doubling = 1; !too_few(samples.size(), job); ++doubling) {
    result = {internal::fit_model(job.target.id, samples, job.centre, job.options.ranges), samples.size()};
    if (!result.model || !result.model->reaches_all || doubling > kMostDoublings) break;
    samples = sample(job.camera.model, domain, job.options.samples << doubling);
    if (rms_over(samples, result.model->model) <= kWorse * result.model->rms_px + kNobodySees) break;
  }
  return result;
}

/// The largest cone, in steps of 5 degrees, on which the target reaches every ray and stays under 1 px rms; failing that, the
/// largest on which it reaches every ray.
SampledFit fit_largest_cone(const Job& job, double& cone_rad) {
  constexpr double kLimitRms = 1.0;  // px
  constexpr int kWidestDeg = 85;
  constexpr int kNarrowestDeg = 20;
  constexpr int kStepDeg = 5;
  SampledFit widest_reaching;
  double widest_angle = 0.0;
  for (int degrees = kWidestDeg; degrees >= kNarrowestDeg; degrees -= kStepDeg) {
    const double angle = degrees * kRadiansPerDegree;
    if (angle >= job.domain.max_angle_rad) continue;
    Domain cone = job.domain;
    cone.max_angle_rad = angle;
    SampledFit candidate = fit(job, cone);
    if (too_few(candidate.samples, job)) break;
    if (!candidate.model || !candidate.model->reaches_all || max_angle(candidate.model->model) < angle) continue;
    if (candidate.model->rms_px <= kLimitRms) {
      cone_rad = angle;
      return candidate;
    }
    if (!widest_reaching.model) {
      widest_reaching = std::move(candidate);
      widest_angle = angle;
    }
  }
  cone_rad = widest_angle;
  return widest_reaching;
}

void warn_of_cone(const Job& job, double cone_rad, Diagnostics& diagnostics) {
  const auto degrees = std::to_string(std::lround(cone_rad / kRadiansPerDegree));
  diagnostics.warning("target-cannot-reach",
                      job.camera.name + ": " + std::string(job.target.id) +
                          " cannot describe this lens as far as the domain goes; it was fitted inside " + degrees +
                          " deg from the axis and gives wrong pixels or none beyond",
                      {}, "kb4, eucm and ds reach further");
}

/// Does nothing beyond double's rounding separate the two models? Then no fit is reported as one.
std::optional<Conversion> exact_conversion(const Job& job) {
  const std::optional<CameraModel> model = internal::convert_exactly(job.camera.model, job.target.id);
  if (!model || !within(*model, job.options.ranges) || !validate(*model).empty()) return std::nullopt;
  Conversion conversion{job.camera, {}};
  conversion.camera.model = *model;
  conversion.report.exact = true;
  return conversion;
}

/// The conversion by a fit. `reach_rad`: where the target was given up, if it cannot describe the whole domain.
std::optional<Conversion> fitted_conversion(const Job& job, double& reach_rad, Diagnostics& diagnostics) {
  const auto start = std::chrono::steady_clock::now();
  SampledFit fitted = fit(job, job.domain);
  if (too_few(fitted.samples, job)) {
    diagnostics.error("domain-too-small",
                      job.camera.name + ": too few pixels of the image have a ray to fit " + std::string(job.target.id));
    return std::nullopt;
  }
  if (!fitted.model || !fitted.model->reaches_all) {
    double cone_rad = 0.0;
    if (SampledFit narrower = fit_largest_cone(job, cone_rad); narrower.model) {
      fitted = std::move(narrower);
      reach_rad = cone_rad;
      warn_of_cone(job, cone_rad, diagnostics);
    }
  }
  if (!fitted.model) {
    diagnostics.error("fit-failed", job.camera.name + ": no " + std::string(job.target.id) + " camera comes near this one");
    return std::nullopt;
  }
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  Conversion conversion{job.camera, {}};
  conversion.camera.model = fitted.model->model;
  conversion.report.fit = {static_cast<int>(fitted.samples), fitted.model->iterations, time.count()};
  conversion.report.at_bound = fitted.model->at_bound;
  return conversion;
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
  std::optional<Domain> domain = domain_of(camera, options.max_angle_rad, diagnostics);
  if (!domain) return std::nullopt;
  const LensCentre centre{central_focal_lengths(camera.model), principal_point(camera.model)};
  const Job job{camera, *target, options, *std::move(domain), centre};

  std::optional<Conversion> conversion = exact_conversion(job);
  double reach_rad = std::numbers::pi;
  if (!conversion) conversion = fitted_conversion(job, reach_rad, diagnostics);
  if (!conversion) return std::nullopt;
  conversion->report.from_model = model_info(camera.model).id;
  conversion->report.to_model = target->id;
  const Projection target_within_reach = [&model = conversion->camera.model, reach_rad](const Ray& ray) {
    return angle_from_axis(ray) <= reach_rad ? project(model, ray) : std::nullopt;
  };
  conversion->report.judgement = judge(camera.model, target_within_reach, job.domain);
  if (!(conversion->report.judgement.coverage.scored > 0.0)) {
    diagnostics.error("nothing-to-compare",
                      camera.name + ": no part of the image could be compared with " + std::string(target->id));
    return std::nullopt;
  }
  return conversion;
}

}  // namespace fca
