// SPDX-License-Identifier: BSD-3-Clause
#include "usual.h"

#include "fixed_parameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fca::internal {

namespace {

/// The parameters outside their usual range, except those that a range of the options fixes at one value.
std::vector<UnusualParameter> unusual_of(const CameraModel& model, std::span<const ParameterRange> ranges) {
  std::vector<UnusualParameter> found;
  const std::span<const double> values = parameter_values(model);
  const std::span<const Parameter> parameters = model_info(model).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& row = parameters[i];
    const bool is_usual = values[i] >= row.usual[0] && values[i] <= row.usual[1];
    const bool is_fixed = std::ranges::any_of(ranges, [&row](const ParameterRange& range) {
      return range.parameter.name() == row.name && range.lower == range.upper;
    });
    if (!is_usual && !is_fixed) found.push_back({std::string(row.name), values[i], row.usual});
  }
  return found;
}

double rms_of(const FieldOfViewFit& fit) { return fit.rms_px; }

/// True if `inside`, the fit inside the usual ranges, is almost as good as the fit without these ranges.
bool is_almost_as_good(const FieldOfViewFit& inside, const FieldOfViewFit& free) {
  constexpr double kMaxRmsRatio = 1.01;
  constexpr double kNegligiblePx = 1e-4;
  constexpr double kNegligibleShare = 1e-3;  // of the image
  return inside.fitted.model &&
         inside.score.statistics.coverage.scored >= free.score.statistics.coverage.scored - kNegligibleShare &&
         rms_of(inside) <= std::max(kMaxRmsRatio * rms_of(free), rms_of(free) + kNegligiblePx);
}

}  // namespace

UsualFit fit_usual(const FitTask& task) {
  constexpr double kExactPx = 1e-6;
  UsualFit result{fit_fixed(task), task.options.ranges, {}};
  if (!result.fit.fitted.model || rms_of(result.fit) < kExactPx) return result;
  result.unusual = unusual_of(result.fit.fitted.model->model, task.options.ranges);
  if (result.unusual.empty()) return result;
  ConvertOptions options = task.options;
  for (const Parameter& row : task.target.parameters) {
    if (std::isfinite(row.usual[0]) || std::isfinite(row.usual[1]))
      options.ranges.push_back({ParameterId(row), row.usual[0], row.usual[1]});
  }
  FieldOfViewFit inside = fit_fixed({task.camera, task.target, options, task.field_of_view, task.centre});
  inside.time += result.fit.time;
  if (is_almost_as_good(inside, result.fit)) return {std::move(inside), std::move(options.ranges), {}};
  for (UnusualParameter& parameter : result.unusual) parameter.rms_inside_px = inside.fitted.model ? rms_of(inside) : 0.0;
  return result;
}

}  // namespace fca::internal
