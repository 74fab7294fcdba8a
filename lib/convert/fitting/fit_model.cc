// SPDX-License-Identifier: BSD-3-Clause
// Only this file instantiates the templates of the fit (JetTarget) for the listed models.
#include "fit_model.h"

#include "../exact.h"
#include "fitter.h"
#include "growing_fit.h"
#include "jet_target.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fca::internal {

namespace {

/// Converts a fit of the model M. nullopt if there is no fit, or its parameters are not valid.
template <CameraModelType M>
std::optional<FittedModel> to_fitted_model(std::optional<FoundFit> fit) {
  if (!fit) return std::nullopt;
  Intrinsics<M> model;
  std::copy_n(fit->parameters.begin(), model.values.size(), model.values.begin());
  FittedModel result{model, fit->rms_px, fit->iterations, fit->reaches_all, std::move(fit->at_bound)};
  if (!validate(result.model).empty()) return std::nullopt;
  return result;
}

/// Fits the model `id` from its own starts only.
std::optional<FittedModel> fit_from_own_starts(std::string_view id, std::span<const Correspondence> samples,
                                               const LensCentre& centre, std::span<const ParameterRange> ranges) {
  std::optional<FittedModel> result;
  ModelList::for_each([&]<CameraModelType M>() {
    if (M::kId == id) result = to_fitted_model<M>(fit_target(JetTarget<M>(), samples, centre, ranges));
  });
  return result;
}

/// True if `a` is better than `b`, or there is no `b`. A fit that reaches all samples is better than one that does not. If both
/// or neither do, the fit with the smaller rms is better.
bool is_better(const FittedModel& a, const std::optional<FittedModel>& b) {
  if (!b) return true;
  if (a.reaches_all != b->reaches_all) return a.reaches_all;
  return a.rms_px < b->rms_px;
}

/// Weighted rms [px] of the distances between the samples' pixels and the model's, over the samples for which the model has a
/// pixel. 0 if it has a pixel for none.
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

/// True if a fit of the contained model `inner` may lead to a better fit than `best`, or to one with fewer parameters at a
/// bound. False if `inner` cannot help: even fitted to a few samples alone, it has a larger rms on them than `best`, which was
/// fitted to all samples.
bool may_be_beaten(const FittedModel& best, std::string_view inner, std::span<const Correspondence> samples,
                   const LensCentre& centre, std::span<const ParameterRange> ranges) {
  constexpr double kNegligiblePx = 1e-3;
  constexpr std::size_t kFewSamples = 48;
  if (!best.reaches_all) return true;
  if (best.rms_px <= kNegligiblePx) return !best.at_bound.empty();
  const std::vector<Correspondence> few = choose_evenly(samples, kFewSamples);
  const std::optional<FittedModel> rival = fit_from_own_starts(inner, few, centre, ranges);
  return !rival || rival->rms_px < rms_over(few, best.model);
}

/// The parameters of the model, followed by zeros.
ParameterValues values_of(const CameraModel& model) {
  ParameterValues values{};
  std::ranges::copy(parameter_values(model), values.begin());
  return values;
}

/// Returns the given camera unchanged, with its rms on the samples. nullopt if it is outside the ranges, or has a pixel for no
/// sample.
std::optional<FittedModel> evaluate_camera(const CameraModel& model, std::span<const Correspondence> samples,
                                           std::span<const ParameterRange> ranges) {
  return std::visit(
      [&]<class M>(const Intrinsics<M>& /*model*/) {
        const JetTarget<M> target;
        return to_fitted_model<M>(Fitter(target, samples, ranges).evaluate_camera(values_of(model)));
      },
      model);
}

/// The fit that starts from the given camera. nullopt if it fails.
std::optional<FittedModel> refit(const CameraModel& start, std::span<const Correspondence> samples,
                                 std::span<const ParameterRange> ranges) {
  return std::visit(
      [&]<class M>(const Intrinsics<M>& /*model*/) {
        const JetTarget<M> target;
        const LensCentre centre{central_focal_lengths(start), principal_point(start)};
        return to_fitted_model<M>(Fitter(target, samples, ranges).refit(values_of(start), centre));
      },
      start);
}

/// Replaces `best` by `fitted` if that is better.
void keep_better(std::optional<FittedModel> fitted, std::optional<FittedModel>& best) {
  if (fitted && is_better(*fitted, best)) best = std::move(fitted);
}

/// Replaces `best` by a fit from `start`, or by `start` itself, if that is better.
void improve_from(const CameraModel& start, std::span<const Correspondence> samples, std::span<const ParameterRange> ranges,
                  std::optional<FittedModel>& best) {
  keep_better(refit(start, samples, ranges), best);
  keep_better(evaluate_camera(start, samples, ranges), best);
}

/// Checks every sample of a model whose image radius may stop growing, and sets reaches_all. A fit takes no notice of the
/// samples at the very edge, whose weights are near 0. Leaves fits of other models unchanged.
void require_every_sample(std::span<const Correspondence> samples, std::optional<FittedModel>& fitted) {
  if (!fitted || !bends_back(model_info(fitted->model).id)) return;
  const double limit = max_angle(fitted->model);
  fitted->reaches_all =
      std::ranges::all_of(samples, [limit](const Correspondence& s) { return angle_from_axis(s.ray) < limit; });
}

/// Starting from `start`, finds the best camera whose image radius grows up to the outermost sample. The model must have growth
/// conditions (growth.h). nullopt if the radius of `start` stops growing before that sample.
std::optional<FittedModel> grow_from(const CameraModel& start, std::span<const Correspondence> samples,
                                     std::span<const ParameterRange> ranges) {
  std::optional<FittedModel> result = std::visit(
      [&]<class M>(const Intrinsics<M>& /*model*/) {
        const JetTarget<M> target;
        return to_fitted_model<M>(fit_growing({target, growth_conditions(M::kId), samples, ranges}, values_of(start)));
      },
      start);
  require_every_sample(samples, result);
  return result && result->reaches_all ? result : std::nullopt;
}

/// Like grow_from(), but starts from a camera without distortion. `coefficient` may make the radius shrink: a first fit holds
/// it at 0, and a second fit starts from the first and frees it. The coefficient therefore never makes the fit worse.
std::optional<FittedModel> grow_from_pinhole(std::string_view id, ParameterId coefficient,
                                             std::span<const Correspondence> samples, const LensCentre& centre,
                                             std::span<const ParameterRange> ranges) {
  const Intrinsics<Pinhole> pinhole{{centre.focal[0], centre.focal[1], centre.point[0], centre.point[1]}};
  const std::optional<CameraModel> start = convert_nearly(pinhole, id);
  if (!start) return std::nullopt;
  std::vector<ParameterRange> without_coefficient(ranges.begin(), ranges.end());
  without_coefficient.push_back({coefficient, 0.0, 0.0});
  const std::optional<FittedModel> first = grow_from(*start, samples, without_coefficient);
  return grow_from(first ? first->model : *start, samples, ranges);
}

}  // namespace

bool is_perspective(std::string_view id) {
  bool result = false;
  ModelList::for_each([&]<CameraModelType M>() {
    if constexpr (requires { M::kPerspective; }) {
      if (M::kId == id) result = M::kPerspective;
    }
  });
  return result;
}

bool has_poles(std::string_view id) {
  bool result = false;
  ModelList::for_each([&]<CameraModelType M>() {
    if (M::kId == id) result = JetTarget<M>().has_poles();
  });
  return result;
}

std::optional<ParameterId> bends_back(std::string_view id) {
  std::optional<ParameterId> result;
  ModelList::for_each([&]<CameraModelType M>() {
    if constexpr (requires { M::kBendsBack; }) {
      if (M::kId == id) result = ParameterId::of<M>(M::kBendsBack);
    }
  });
  return result;
}

bool may_end_early(std::string_view id) { return has_poles(id) || bends_back(id); }

std::optional<FittedModel> fit_model(std::string_view id, std::span<const Correspondence> samples, const LensCentre& centre,
                                     std::span<const ParameterRange> ranges, MustReach must_reach) {
  std::optional<FittedModel> best = fit_from_own_starts(id, samples, centre, ranges);
  if (must_reach == MustReach::kEverySample) require_every_sample(samples, best);
  if (const std::optional<ParameterId> coefficient = bends_back(id); coefficient && (!best || !best->reaches_all)) {
    keep_better(grow_from_pinhole(id, *coefficient, samples, centre, ranges), best);
  }
  const std::string_view inner = contained_model(id);
  if (inner.empty() || (best && !may_be_beaten(*best, inner, samples, centre, ranges))) return best;
  if (const std::optional<FittedModel> contained = fit_model(inner, samples, centre, ranges, must_reach)) {
    if (const std::optional<CameraModel> start = convert_nearly(contained->model, id)) {
      // If the contained model is exact to 1e-5 px, its camera is the result: a further fit could make the additional
      // parameters extreme for a smaller gain.
      constexpr double kNegligiblePx = 1e-5;
      std::optional<FittedModel> unchanged = evaluate_camera(*start, samples, ranges);
      if (unchanged && unchanged->reaches_all && unchanged->rms_px <= kNegligiblePx) return unchanged;
      improve_from(*start, samples, ranges, best);
    }
  }
  return best;
}

std::unique_ptr<FitTarget> fit_target_of(const CameraModel& model) {
  return std::visit(
      []<class M>(const Intrinsics<M>& /*model*/) -> std::unique_ptr<FitTarget> { return std::make_unique<JetTarget<M>>(); },
      model);
}

std::optional<FittedModel> fit_from(const CameraModel& start, std::span<const Correspondence> samples,
                                    std::span<const ParameterRange> ranges) {
  std::optional<FittedModel> best = refit(start, samples, ranges);
  require_every_sample(samples, best);
  const std::string_view id = model_info(start).id;
  if (const std::optional<ParameterId> coefficient = bends_back(id); coefficient && (!best || !best->reaches_all)) {
    std::optional<FittedModel> growing = grow_from(start, samples, ranges);
    const LensCentre centre{central_focal_lengths(start), principal_point(start)};
    keep_better(growing ? std::move(growing) : grow_from_pinhole(id, *coefficient, samples, centre, ranges), best);
  }
  std::optional<FittedModel> unchanged = evaluate_camera(start, samples, ranges);
  require_every_sample(samples, unchanged);
  keep_better(std::move(unchanged), best);
  return best;
}

}  // namespace fca::internal
