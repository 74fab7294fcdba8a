// SPDX-License-Identifier: BSD-3-Clause
#include "fixed_parameters.h"

#include <fca/code.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace fca::internal {

namespace {

constexpr ParameterId kFx = "fx";
constexpr ParameterId kFy = "fy";

/// True if the model has a parameter with this name.
bool has(const ModelInfo& model, const ParameterId& parameter) {
  return std::ranges::find(model.parameters, parameter.name(), &Parameter::name) != model.parameters.end();
}

/// The fit in which both focal lengths are fixed at `f` [px].
FieldOfViewFit fit_with_focal_length(const FitTask& task, double f) {
  ConvertOptions options = task.options;
  for (const ParameterId focal : {kFx, kFy}) options.ranges.push_back({focal, f, f});
  return fit_field_of_view({task.camera, task.target, options, task.field_of_view, task.centre});
}

/// The rms [px] that the search minimises; infinite if the fit has no model.
double cost_of(const FieldOfViewFit& fit) { return fit.fitted.model ? fit.rms_px : std::numeric_limits<double>::infinity(); }

/// Returns the bounds of an interval that contains a minimum of the cost. Goes downhill from `middle` until the cost rises, at
/// most 12 steps, of which each is twice as long as the one before. The minimum may be far away: in mei and ds, f and xi change
/// together along a long valley.
std::pair<double, double> bracket_of_minimum(double middle, double step, const std::function<double(double)>& cost_at) {
  constexpr int kMostSteps = 12;
  const double cost_at_start = cost_at(middle);
  const double direction = cost_at(middle + step) < cost_at_start ? 1.0 : -1.0;
  double before = middle - direction * step;
  double cost = cost_at_start;
  for (int i = 0; i < kMostSteps; ++i, step *= 2.0) {
    const double next = middle + direction * step;
    const double cost_next = next > 0.0 ? cost_at(next) : std::numeric_limits<double>::infinity();
    if (!(cost_next < cost)) return std::minmax({before, std::max(next, 0.0)});
    before = std::exchange(middle, next);
    cost = cost_next;
  }
  return std::minmax({before, middle});
}

}  // namespace

std::optional<ConvertOptions> with_fixed(const Camera& source, const ModelInfo& target, ConvertOptions options,
                                         Diagnostics& diagnostics) {
  options.ranges.insert(options.ranges.end(), options.fixed.at.begin(), options.fixed.at.end());
  for (const ParameterId kept : options.fixed.kept) {
    const std::optional<double> value = source.rays.empty() ? parameter(source.model, kept) : std::nullopt;
    if (!value) {
      diagnostics.add(Code::kNothingToKeep, {source.name, source.lens_id(), kept.name()});
      return std::nullopt;
    }
    options.ranges.push_back({kept, *value, *value});
  }
  if (options.fixed.one_focal_length && !(has(target, kFx) && has(target, kFy))) {
    diagnostics.add(Code::kTiesFocalLengthsOnly, {target.id});
    return std::nullopt;
  }
  if (options.fixed.one_focal_length && !source.rays.empty()) {
    diagnostics.add(Code::kOneFocalLengthOfRays, {source.name});
    return std::nullopt;
  }
  return options;
}

FieldOfViewFit fit_fixed(const FitTask& task) {
  FieldOfViewFit free = fit_field_of_view(task);
  if (!task.options.fixed.one_focal_length || !free.fitted.model) return free;
  const double fx = parameter(free.fitted.model->model, kFx).value();
  const double fy = parameter(free.fitted.model->model, kFy).value();
  if (fx == fy) return free;
  const auto cost_at = [&task](double f) { return cost_of(fit_with_focal_length(task, f)); };
  const auto bracket = bracket_of_minimum(0.5 * (fx + fy), std::max(std::abs(fx - fy), 0.01 * fx), cost_at);
  double low = bracket.first;
  double high = bracket.second;
  const double first_width = high - low;
  constexpr double kGoldenRatio = 0.6180339887498949;
  constexpr double kLastWidthRatio = 1e-5;  // to the first interval; the rms hardly changes near the minimum
  const auto point_at = [&](double share) { return low + share * (high - low); };
  double left = point_at(1.0 - kGoldenRatio);
  double right = point_at(kGoldenRatio);
  FieldOfViewFit fit_left = fit_with_focal_length(task, left);
  FieldOfViewFit fit_right = fit_with_focal_length(task, right);
  auto time = free.time + fit_left.time + fit_right.time;
  while (high - low > kLastWidthRatio * first_width) {
    const bool is_left = cost_of(fit_left) < cost_of(fit_right);
    if (is_left) {
      high = std::exchange(right, left);
      fit_right = std::exchange(fit_left, fit_with_focal_length(task, left = point_at(1.0 - kGoldenRatio)));
    } else {
      low = std::exchange(left, right);
      fit_left = std::exchange(fit_right, fit_with_focal_length(task, right = point_at(kGoldenRatio)));
    }
    time += (is_left ? fit_left : fit_right).time;
  }
  fit_left.time = fit_right.time = time;
  return cost_of(fit_left) < cost_of(fit_right) ? std::move(fit_left) : std::move(fit_right);
}

}  // namespace fca::internal
