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

std::optional<internal::FittedModel> fit(const Job& job, std::span<const Correspondence> samples) {
  return internal::fit_model(job.target.id, samples, job.centre, job.options.ranges);
}

/// The largest cone, in steps of 5 degrees, on which the target reaches every ray and stays under 1 px rms; failing that, the
/// largest on which it reaches every ray.
std::optional<internal::FittedModel> fit_largest_cone(const Job& job, double& cone_rad) {
  constexpr double kLimitRms = 1.0;  // px
  constexpr int kWidestDeg = 85;
  constexpr int kNarrowestDeg = 20;
  constexpr int kStepDeg = 5;
  std::optional<internal::FittedModel> widest_reaching;
  double widest_angle = 0.0;
  for (int degrees = kWidestDeg; degrees >= kNarrowestDeg; degrees -= kStepDeg) {
    const double angle = degrees * kRadiansPerDegree;
    if (angle >= job.domain.max_angle_rad) continue;
    Domain cone = job.domain;
    cone.max_angle_rad = angle;
    const std::vector<Correspondence> inside = sample(job.camera.model, cone, job.options.samples);
    if (inside.size() * 2 < job.target.parameters.size()) break;
    std::optional<internal::FittedModel> candidate = fit(job, inside);
    if (!candidate || !candidate->reaches_all || max_angle(candidate->model) < angle) continue;
    if (candidate->rms_px <= kLimitRms) {
      cone_rad = angle;
      return candidate;
    }
    if (!widest_reaching) {
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
  const std::vector<Correspondence> samples = sample(job.camera.model, job.domain, job.options.samples);
  if (samples.size() * 2 < job.target.parameters.size()) {
    diagnostics.error("domain-too-small",
                      job.camera.name + ": too few pixels of the image have a ray to fit " + std::string(job.target.id));
    return std::nullopt;
  }
  std::optional<internal::FittedModel> fitted = fit(job, samples);
  if (!fitted || !fitted->reaches_all) {
    double cone_rad = 0.0;
    if (std::optional<internal::FittedModel> narrower = fit_largest_cone(job, cone_rad)) {
      fitted = std::move(narrower);
      reach_rad = cone_rad;
      warn_of_cone(job, cone_rad, diagnostics);
    }
  }
  if (!fitted) {
    diagnostics.error("fit-failed", job.camera.name + ": no " + std::string(job.target.id) + " camera comes near this one");
    return std::nullopt;
  }
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  Conversion conversion{job.camera, {}};
  conversion.camera.model = fitted->model;
  conversion.report.fit = {static_cast<int>(samples.size()), fitted->iterations, time.count()};
  conversion.report.at_bound = fitted->at_bound;
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
