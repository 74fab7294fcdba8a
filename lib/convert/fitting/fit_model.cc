// SPDX-License-Identifier: BSD-3-Clause
// The only file that instantiates the fit for the listed models.
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

template <CameraModelType M>
std::optional<FittedModel> listed(std::optional<FoundFit> fit) {
  if (!fit) return std::nullopt;
  Intrinsics<M> model;
  std::copy_n(fit->parameters.begin(), model.values.size(), model.values.begin());
  FittedModel result{model, fit->rms_px, fit->iterations, fit->reaches_all, std::move(fit->at_bound)};
  if (!validate(result.model).empty()) return std::nullopt;
  return result;
}

std::optional<FittedModel> fit_from_own_starts(std::string_view id, std::span<const Correspondence> samples,
                                               const LensCentre& centre, std::span<const ParameterRange> ranges) {
  std::optional<FittedModel> result;
  ModelList::for_each([&]<CameraModelType M>() {
    if (M::kId == id) result = listed<M>(fit_target(JetTarget<M>(), samples, centre, ranges));
  });
  return result;
}

/// True if `a` is the better fit: the one that reaches all samples or, if both or neither do, the one with the smaller rms.
bool better(const FittedModel& a, const std::optional<FittedModel>& b) {
  if (!b) return true;
  if (a.reaches_all != b->reaches_all) return a.reaches_all;
  return a.rms_px < b->rms_px;
}

/// Weighted rms [px] of the distances between the samples' pixels and the model's. Samples without a pixel in the model do not
/// count.
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

/// True if a fit of the contained model `inner` may lead to a better fit, or to a plainer one where a parameter ran to its
/// bound. It cannot if its fit to a few samples is worse on these than `best`, which was fitted to all.
bool may_be_beaten(const FittedModel& best, std::string_view inner, std::span<const Correspondence> samples,
                   const LensCentre& centre, std::span<const ParameterRange> ranges) {
  constexpr double kNobodySees = 1e-3;  // px
  constexpr std::size_t kFew = 48;
  if (!best.reaches_all) return true;
  if (best.rms_px <= kNobodySees) return !best.at_bound.empty();
  const std::vector<Correspondence> few = spread(samples, kFew);
  const std::optional<FittedModel> rival = fit_from_own_starts(inner, few, centre, ranges);
  return !rival || rival->rms_px < rms_over(few, best.model);
}

ParameterValues values_of(const CameraModel& model) {
  ParameterValues values{};
  std::ranges::copy(parameter_values(model), values.begin());
  return values;
}

/// The given camera with its rms on the samples; nullopt if it lies outside the ranges.
std::optional<FittedModel> as_it_is(const CameraModel& model, std::span<const Correspondence> samples,
                                    std::span<const ParameterRange> ranges) {
  return std::visit(
      [&]<class M>(const Intrinsics<M>& /*model*/) {
        const JetTarget<M> target;
        return listed<M>(Fitter(target, samples, ranges).as_it_is(values_of(model)));
      },
      model);
}

/// The fit that starts from the given camera.
std::optional<FittedModel> refit(const CameraModel& start, std::span<const Correspondence> samples,
                                 std::span<const ParameterRange> ranges) {
  return std::visit(
      [&]<class M>(const Intrinsics<M>& /*model*/) {
        const JetTarget<M> target;
        const LensCentre centre{central_focal_lengths(start), principal_point(start)};
        return listed<M>(Fitter(target, samples, ranges).refit(values_of(start), centre));
      },
      start);
}

void keep_better(std::optional<FittedModel> fitted, std::optional<FittedModel>& best) {
  if (fitted && better(*fitted, best)) best = std::move(fitted);
}

/// Replaces `best` by a fit from `start`, or by `start` itself, if that is better.
void improve_from(const CameraModel& start, std::span<const Correspondence> samples, std::span<const ParameterRange> ranges,
                  std::optional<FittedModel>& best) {
  keep_better(refit(start, samples, ranges), best);
  keep_better(as_it_is(start, samples, ranges), best);
}

/// An image radius may turn back just before the edge, where the samples have no weight. Such a fit counts as one that does not
/// reach all samples.
void require_every_sample(std::span<const Correspondence> samples, std::optional<FittedModel>& fitted) {
  if (!fitted || !bends_back(model_info(fitted->model).id)) return;
  const double last = max_angle(fitted->model);
  fitted->reaches_all = std::ranges::all_of(samples, [last](const Correspondence& s) { return angle_from_axis(s.ray) < last; });
}

/// The best camera, starting from `start`, of a model with growth conditions (growth.h) whose radius grows up to the outermost
/// sample; nullopt if the radius of `start` does not.
std::optional<FittedModel> grow_from(const CameraModel& start, std::span<const Correspondence> samples,
                                     std::span<const ParameterRange> ranges) {
  std::optional<FittedModel> result = std::visit(
      [&]<class M>(const Intrinsics<M>& /*model*/) {
        const JetTarget<M> target;
        return listed<M>(fit_growing({target, growth_conditions(M::kId), samples, ranges}, values_of(start)));
      },
      start);
  require_every_sample(samples, result);
  return result && result->reaches_all ? result : std::nullopt;
}

/// Like grow_from(), from a camera without distortion. Fits first without the coefficient that may bend the radius back, then
/// with it, so that the additional coefficient never makes the fit worse.
std::optional<FittedModel> grow(std::string_view id, ParameterId bends, std::span<const Correspondence> samples,
                                const LensCentre& centre, std::span<const ParameterRange> ranges) {
  const Intrinsics<Pinhole> pinhole{{centre.focal[0], centre.focal[1], centre.point[0], centre.point[1]}};
  const std::optional<CameraModel> start = convert_nearly(pinhole, id);
  if (!start) return std::nullopt;
  std::vector<ParameterRange> without(ranges.begin(), ranges.end());
  without.push_back({bends, 0.0, 0.0});
  const std::optional<FittedModel> lower = grow_from(*start, samples, without);
  return grow_from(lower ? lower->model : *start, samples, ranges);
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
  if (const std::optional<ParameterId> bends = bends_back(id); bends && (!best || !best->reaches_all)) {
    keep_better(grow(id, *bends, samples, centre, ranges), best);
  }
  const std::string_view inner = contained_model(id);
  if (inner.empty() || (best && !may_be_beaten(*best, inner, samples, centre, ranges))) return best;
  if (const std::optional<FittedModel> contained = fit_model(inner, samples, centre, ranges, must_reach)) {
    if (const std::optional<CameraModel> start = convert_nearly(contained->model, id)) {
      // Near the limit of the contained model the additional parameters could grow without bound, for a gain below 1e-5 px.
      constexpr double kNobodySees = 1e-5;  // px
      std::optional<FittedModel> near = as_it_is(*start, samples, ranges);
      if (near && near->reaches_all && near->rms_px <= kNobodySees) return near;
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
  if (const std::optional<ParameterId> bends = bends_back(id); bends && (!best || !best->reaches_all)) {
    std::optional<FittedModel> grows = grow_from(start, samples, ranges);
    const LensCentre centre{central_focal_lengths(start), principal_point(start)};
    keep_better(grows ? std::move(grows) : grow(id, *bends, samples, centre, ranges), best);
  }
  std::optional<FittedModel> unchanged = as_it_is(start, samples, ranges);
  require_every_sample(samples, unchanged);
  keep_better(std::move(unchanged), best);
  return best;
}

}  // namespace fca::internal
