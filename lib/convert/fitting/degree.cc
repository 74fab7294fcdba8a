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

/// The coefficients that a polynomial of the lowest degree does not have, in ascending order of their powers. Empty if the
/// model is no polynomial of variable degree.
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

/// The number of `terms` up to the last one that the options' ranges let differ from 0. nullopt if no range is about a term.
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

/// Fits the target with the given degree and its ranges.
DegreeFit fit_with(const FitTask& task, const DegreeRanges& degree) {
  ConvertOptions options = task.options;
  options.ranges = degree.ranges;
  UsualFit usual = fit_usual({task.camera, task.target, options, task.field_of_view, task.centre});
  return {std::move(usual.fit), std::move(usual.ranges), degree.degree, std::move(usual.unusual)};
}

/// The number of pixels with a ray, of 36 at the image's border. A fitted polynomial may have a maximum inside the image,
/// outside the angles that were fitted. Pixels beyond this maximum have no ray.
int rays_at_border(const DegreeFit& fit, const ImageSize& size) {
  constexpr int kSteps = 8;  // along each side
  const double right = size.width - 1.0;
  const double bottom = size.height - 1.0;
  int rays = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double u = right * i / kSteps;
    const double v = bottom * i / kSteps;
    for (const Pixel& pixel : {Pixel{u, 0.0}, Pixel{u, bottom}, Pixel{0.0, v}, Pixel{right, v}})
      rays += unproject(fit.fit.fitted.model->model, pixel) ? 1 : 0;
  }
  return rays;
}

double rms_of(const DegreeFit& each) { return each.fit.rms_px; }

}  // namespace

std::vector<DegreeRanges> degrees_to_try(const ModelInfo& target, const ConvertOptions& options) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  const std::vector<ParameterId> terms = higher_terms(target.id);
  if (terms.empty()) return {{target.least_degree, options.ranges}};
  if (const std::optional<std::size_t> freed = freed_by_ranges(options, terms))
    return {{target.least_degree + static_cast<int>(*freed), options.ranges}};
  std::vector<DegreeRanges> degrees;
  std::vector<ParameterRange> ranges = options.ranges;
  for (std::size_t count = 0; count <= terms.size(); ++count) {
    const int degree = target.least_degree + static_cast<int>(count);
    if (!options.degree || degree == *options.degree) degrees.push_back({degree, ranges});
    if (count < terms.size()) ranges.push_back({terms[count], -kUnlimited, kUnlimited});
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
  constexpr double kNegligibleShare = 1e-3;  // of the image
  const auto covered = [](const DegreeFit& each) { return each.fit.score.statistics.coverage.scored; };
  for (const DegreeRanges& degree : degrees) {
    DegreeFit fit = fit_with(task, degree);
    const bool has_model = fit.fit.fitted.model.has_value();
    const bool covers_less =
        has_model && !fits.empty() &&
        (covered(fit) < covered(fits.front()) - kNegligibleShare ||
         rays_at_border(fit, task.field_of_view.size) < rays_at_border(fits.front(), task.field_of_view.size));
    const bool first_failed = !has_model && fits.empty();
    if ((has_model && !covers_less) || first_failed) fits.push_back(std::move(fit));
    if (first_failed) return fits;
    if (rms_of(fits.back()) < kGoodEnoughPx) break;
  }
  const double enough = std::max(kGoodEnoughPx, kNearlyAsGood * rms_of(*std::ranges::min_element(fits, {}, rms_of)));
  const auto chosen = std::ranges::find_if(fits, [enough](const DegreeFit& each) { return rms_of(each) <= enough; });
  fits.erase(chosen + 1, fits.end());
  std::ranges::reverse(fits);
  return fits;
}

}  // namespace fca::internal
