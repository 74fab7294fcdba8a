// SPDX-License-Identifier: BSD-3-Clause
#include "polisher.h"

#include "normal_equations.h"
#include "variable_projection.h"

#include <algorithm>
#include <cmath>

namespace fca::internal {

namespace {

/// refine() continues if a round reduces the cost to less than this fraction.
constexpr double kWorthwhileCostRatio = 0.9;

}  // namespace

Polisher::Polisher(const FitTarget& target, std::span<const ParameterRange> ranges)
    : target_(target), parameter_count_(target.parameters().size()), jacobian_(target), limits_(target, ranges) {}

void Polisher::apply_ranges(Candidate& candidate) const {
  for (std::size_t i = 0; i < parameter_count_; ++i) {
    candidate.fixed[i] = limits_.fixed(i);
    candidate.values[i] = std::clamp(candidate.values[i], limits_.lower[i], limits_.upper[i]);
  }
}

/// A start may have no pixel for some samples. The minimisation then begins without these. Its result usually has pixels for
/// more samples, which the next round includes.
bool Polisher::polish(Candidate& candidate, std::span<const Correspondence> samples, const Effort& effort) {
  constexpr int kMostRounds = 4;
  std::size_t before = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    pixels_.resize(samples.size());
    std::vector<Correspondence> active;
    if (target_.pixels(candidate.values.data(), samples, pixels_.data())) {
      active.assign(samples.begin(), samples.end());
    } else {
      for (std::size_t k = 0; k < samples.size(); ++k) {
        if (!std::isnan(pixels_[k][0])) active.push_back(samples[k]);
      }
    }
    if (active.size() * 2 < parameter_count_ || (round > 0 && active.size() <= before)) break;
    before = active.size();
    jacobian_.reset(std::move(active), candidate.fixed);
    if (!minimise_active(candidate, samples.size(), effort)) return false;
    if (before == samples.size()) break;
  }
  return before > 0;
}

/// Minimises over the samples of jacobian_, which are those that have pixels. `samples`: the number of all samples. False if
/// the start cannot be evaluated.
bool Polisher::minimise_active(Candidate& candidate, std::size_t samples, const Effort& effort) {
  ParameterValues free{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < parameter_count_; ++i) {
    if (!candidate.fixed[i]) free[count++] = candidate.values[i];
  }
  if (count == 0) {
    candidate.cost_is_complete = false;
    return true;
  }
  const std::span<double> values = std::span(free).first(count);
  Minimum minimum;
  if (VariableProjection::can_fit(target_, candidate.fixed)) minimum = minimise_shape(candidate, effort, values);
  if (!minimum.usable) minimum = minimise_free(candidate, effort, values);
  if (!minimum.usable) return false;
  candidate.cost = minimum.cost;
  candidate.iterations += minimum.iterations;
  candidate.cost_is_complete = jacobian_.rows() == 2 * samples;
  if (minimum.cost < kSmallCost) refine(candidate, effort, values);
  candidate.values = merged(candidate, free.data());
  return true;
}

/// Minimises over the free parameters, starting from `free`, which receives the result.
Minimum Polisher::minimise_free(const Candidate& candidate, const Effort& effort, std::span<double> free) {
  const Evaluate evaluate_at = [this, &candidate](const double* p, NormalEquations& sums) {
    return jacobian_.evaluate(merged(candidate, p), sums);
  };
  // If the start's cost is below kTinyCost, the rounding errors of J'J are too large for a step. refine() then continues from
  // the start.
  constexpr double kTinyCost = 1e-9;
  NormalEquations at_start;
  if (!evaluate_at(free.data(), at_start)) return {};
  if (has_many_parameters(target_) && at_start.cost < kTinyCost) return {true, at_start.cost, 0};
  return minimise(evaluate_at, effort, free);
}

/// Minimises over the shape alone, with the best focal lengths and centre for each shape (variable_projection.h). `free`
/// receives all free parameters of the result.
Minimum Polisher::minimise_shape(const Candidate& candidate, const Effort& effort, std::span<double> free) {
  VariableProjection projection(jacobian_, candidate.values, candidate.fixed);
  const Evaluate evaluate_at = [&projection](const double* shape, NormalEquations& sums) {
    return projection.evaluate(shape, sums);
  };
  ParameterValues shape{};
  const std::span<double> parameters = std::span(shape).first(projection.shape().size());
  std::ranges::copy(projection.shape(), parameters.begin());
  const Minimum minimum = minimise(evaluate_at, effort, parameters);
  if (!minimum.usable) return minimum;
  const ParameterValues values = projection.values_at(parameters);
  for (std::size_t i = 0, k = 0; i < parameter_count_; ++i) {
    if (!candidate.fixed[i]) free[k++] = values[i];
  }
  return minimum;
}

/// Continues the minimisation in coordinates in which the Jacobian's columns are orthonormal at the start. J'J has the squared
/// condition number of J, so that its rounding errors hide the last gains in a narrow valley. Repeats this with new coordinates
/// while it helps, because the columns are orthonormal only near one point.
void Polisher::refine(Candidate& candidate, const Effort& effort, std::span<double> free) {
  constexpr int kMostRounds = 8;
  for (int round = 0; round < kMostRounds && candidate.cost > kExactCost; ++round) {
    if (!jacobian_.compute_jacobian(merged(candidate, free.data()))) return;
    qr_.reset(jacobian_.rows(), jacobian_.columns().size());
    for (const Column& column : jacobian_.columns()) qr_.add(column.data);
    ParameterValues centre{};
    std::ranges::copy(free, centre.begin());
    const auto free_at = [&](const double* y) {
      ParameterValues values = centre;
      qr_.step(y, values.data());
      return values;
    };
    const Evaluate evaluate_at = [&](const double* y, NormalEquations& sums) {
      const ParameterValues values = merged(candidate, free_at(y).data());
      if (sums.gradient.empty()) return jacobian_.evaluate(values, sums);
      if (!jacobian_.compute_jacobian(values)) return false;
      qr_.transform(jacobian_.columns(), transformed_);
      const Column r = jacobian_.residuals();
      dot_products(std::span(&r, 1), r, &sums.cost);
      dot_products(qr_.columns(transformed_), r, sums.gradient.data());
      dot_products(qr_.columns(transformed_), sums.hessian.data());
      return true;
    };
    ParameterValues y{};
    const Minimum minimum = minimise(evaluate_at, effort, std::span(y).first(free.size()));
    if (!minimum.usable || !(minimum.cost < candidate.cost)) return;
    std::copy_n(free_at(y.data()).begin(), free.size(), free.begin());
    const bool helps = minimum.cost < kWorthwhileCostRatio * candidate.cost;
    candidate.cost = minimum.cost;
    candidate.iterations += minimum.iterations;
    if (!helps) return;
  }
}

/// The parameters of the candidate, where those in `free` replace the ones that are not fixed.
ParameterValues Polisher::merged(const Candidate& candidate, const double* free) const {
  ParameterValues values = candidate.values;
  for (std::size_t i = 0, k = 0; i < parameter_count_; ++i) {
    if (!candidate.fixed[i]) values[i] = free[k++];
  }
  return values;
}

/// Each round fixes only the parameter that is furthest outside its range: the next minimisation may bring the others back.
void Polisher::respect_bounds(Candidate& candidate, std::span<const Correspondence> samples, const Effort& effort) {
  for (std::size_t round = 0; round < parameter_count_; ++round) {
    std::optional<std::size_t> worst;
    double furthest = 0.0;
    for (std::size_t i = 0; i < parameter_count_; ++i) {
      const double value = candidate.values[i];
      const double outside = std::max(limits_.lower[i] - value, value - limits_.upper[i]) / (1.0 + std::abs(value));
      if (!candidate.fixed[i] && outside > furthest) {
        furthest = outside;
        worst = i;
      }
    }
    if (!worst) return;
    candidate.values[*worst] = std::clamp(candidate.values[*worst], limits_.lower[*worst], limits_.upper[*worst]);
    candidate.fixed[*worst] = true;
    if (polish(candidate, samples, effort)) continue;
    candidate.cost_is_complete = false;  // the cost is that of the values before
    return;
  }
}

/// Computes result.rms_px over the samples in the model's domain, and result.reaches_all: whether these are all samples, or all
/// except the very edge (kVeryEdge). False if no sample is in the domain.
bool Polisher::score(const Candidate& candidate, std::span<const Correspondence> samples, FoundFit& result) const {
  double weight = 0.0;
  double lowest = 1.0;  // cosine of the samples' largest angle from the axis
  for (const Correspondence& s : samples) {
    weight += s.weight;
    lowest = std::min(lowest, s.ray[2]);
  }
  // A comparison of each ray with the largest angle of the domain is faster than project(). Only for rays close to this angle
  // does project() decide. If all rays are inside, the fit's cost gives the rms.
  constexpr double kRoundingMargin = 1e-9;
  const double limit = std::cos(target_.max_angle(candidate.values.data()));
  if (candidate.cost_is_complete && lowest > limit + kRoundingMargin) {
    result.rms_px = std::sqrt(candidate.cost / weight);
    return true;
  }
  std::vector<std::array<double, 2>> pixels(samples.size());
  target_.pixels(candidate.values.data(), samples, pixels.data());
  const double whole_weight = weight;
  std::size_t missed = 0;
  weight = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Correspondence& s = samples[k];
    std::array<double, 2>& pixel = pixels[k];
    const bool is_close_to_limit = std::abs(s.ray[2] - limit) <= kRoundingMargin;
    const bool inside = is_close_to_limit ? target_.project(candidate.values.data(), s.ray.data(), pixel.data())
                                          : s.ray[2] > limit && !std::isnan(pixel[0]);
    if (!inside) {
      ++missed;
      continue;
    }
    weight += s.weight;
    sum += s.weight * (std::pow(pixel[0] - s.pixel[0], 2) + std::pow(pixel[1] - s.pixel[1], 2));
  }
  // A pole also spoils the pixels around it. A model that may have poles must therefore have a pixel for every sample.
  result.reaches_all = missed == 0 || (!target_.has_poles() && whole_weight - weight <= kVeryEdge * whole_weight);
  if (!(weight > 0.0)) return false;
  result.rms_px = std::sqrt(sum / weight);
  return true;
}

std::optional<FoundFit> Polisher::finish(const Candidate& candidate, std::span<const Correspondence> samples) const {
  FoundFit result;
  result.parameters = candidate.values;
  result.iterations = candidate.iterations;
  if (!score(candidate, samples, result)) return std::nullopt;
  for (std::size_t i = 0; i < parameter_count_; ++i) {
    if (candidate.fixed[i] && !limits_.fixed(i)) result.at_bound.emplace_back(target_.parameters()[i].name);
  }
  return result;
}

}  // namespace fca::internal
