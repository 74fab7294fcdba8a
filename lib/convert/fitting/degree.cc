// SPDX-License-Identifier: BSD-3-Clause
#include "degree.h"

#include "usual.h"

#include <fca/models/camera_model.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace fca::internal {

namespace {

/// The coefficients that a model of the lowest degree does not have.
std::vector<ParameterId> higher_terms(std::string_view model) {
  std::vector<ParameterId> terms;
  ModelList::for_each([&]<CameraModelType M>() {
    if constexpr (requires { M::kHigherTerms; }) {
      if (M::kId != model) return;
      for (const std::string_view term : M::kHigherTerms)
        terms.push_back(ParameterId(*std::ranges::find(M::kParameters, term, &Parameter::name)));
    }
  });
  return terms;
}

/// The number of terms up to the last one that the caller's ranges leave free; nullopt if no range names a term.
std::optional<std::size_t> freed_by_ranges(const ConvertOptions& options, const std::vector<ParameterId>& terms) {
  std::optional<std::size_t> count;
  for (const ParameterRange& range : options.ranges) {
    const auto term = std::ranges::find(terms, range.parameter.name(), &ParameterId::name);
    if (term == terms.end()) continue;
    const bool is_free = range.lower != 0.0 || range.upper != 0.0;
    const auto up_to = is_free ? static_cast<std::size_t>(term - terms.begin()) + 1 : 0;
    count = std::max(count.value_or(0), up_to);
  }
  return count;
}

DegreeFit fit_with(const FitTask& task, const DegreeRanges& degree) {
  ConvertOptions options = task.options;
  options.ranges = degree.ranges;
  UsualFit usual = fit_usual({task.camera, task.target, options, task.field_of_view, task.centre});
  return {std::move(usual.fit), std::move(usual.ranges), degree.degree, std::move(usual.unusual)};
}

/// The number of points of the image's border that have a ray. A fitted polynomial may have a maximum inside the image, outside
/// the angles that it was fitted to; pixels beyond that have no ray.
int rays_at_border(const DegreeFit& each, const ImageSize& size) {
  constexpr int kSteps = 8;  // along each side
  const double right = size.width - 1.0;
  const double bottom = size.height - 1.0;
  int rays = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double u = right * i / kSteps;
    const double v = bottom * i / kSteps;
    for (const Pixel& pixel : {Pixel{u, 0.0}, Pixel{u, bottom}, Pixel{0.0, v}, Pixel{right, v}})
      rays += unproject(each.fit.fitted.model->model, pixel) ? 1 : 0;
  }
  return rays;
}

double rms_of(const DegreeFit& each) { return each.fit.rms_px; }

}  // namespace

std::vector<DegreeRanges> degrees_to_try(const ModelInfo& target, const ConvertOptions& options) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const std::vector<ParameterId> terms = higher_terms(target.id);
  if (terms.empty()) return {{target.least_degree, options.ranges}};
  if (const std::optional<std::size_t> freed = freed_by_ranges(options, terms))
    return {{target.least_degree + static_cast<int>(*freed), options.ranges}};
  std::vector<DegreeRanges> degrees;
  std::vector<ParameterRange> ranges = options.ranges;
  for (std::size_t count = 0; count <= terms.size(); ++count) {
    const int degree = target.least_degree + static_cast<int>(count);
    if (!options.degree || degree == *options.degree) degrees.push_back({degree, ranges});
    if (count < terms.size()) ranges.push_back({terms[count], -kAny, kAny});
  }
  return degrees;
}

std::vector<DegreeFit> fit_degrees(const FitTask& task) {
  std::vector<DegreeFit> fits;
  const std::vector<DegreeRanges> degrees = degrees_to_try(task.target, task.options);
  if (degrees.size() == 1) {
    fits.push_back(fit_with(task, degrees.front()));
    return fits;
  }
  constexpr double kSameShare = 1e-3;
  const auto reached = [](const DegreeFit& each) { return each.fit.score.statistics.coverage.scored; };
  for (const DegreeRanges& degree : degrees) {
    DegreeFit fit = fit_with(task, degree);
    const bool has_model = fit.fit.fitted.model.has_value();
    const bool reaches_less =
        has_model && !fits.empty() &&
        (reached(fit) < reached(fits.front()) - kSameShare ||
         rays_at_border(fit, task.field_of_view.size) < rays_at_border(fits.front(), task.field_of_view.size));
    const bool is_no_camera = !has_model && fits.empty();
    if ((has_model && !reaches_less) || is_no_camera) fits.push_back(std::move(fit));
    if (is_no_camera) return fits;
    if (rms_of(fits.back()) < kGoodEnoughPx) break;
  }
  const double enough = std::max(kGoodEnoughPx, kNearlyAsGood * rms_of(*std::ranges::min_element(fits, {}, rms_of)));
  const auto chosen = std::ranges::find_if(fits, [enough](const DegreeFit& each) { return rms_of(each) <= enough; });
  fits.erase(chosen + 1, fits.end());
  std::ranges::reverse(fits);
  return fits;
}

}  // namespace fca::internal
