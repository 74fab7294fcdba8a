// SPDX-License-Identifier: BSD-3-Clause
// Fits one camera model to rays and pixels: linear starts, then Levenberg-Marquardt on the geometric residual (pixels), bounds
// by taking the active parameter out of the step. Whether the fitted camera folds inside the samples is asked afterwards. A
// template over the model concept: works for any model, listed or not.
#pragma once

#include "minimise.h"

#include <fca/convert/convert.h>
#include <fca/models/model_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <ceres/jet.h>

namespace fca::internal {

/// `count` of the samples (all, if there are no more), spread by the golden ratio: a stride would pick the same radii again and
/// again from samples that come in rows.
inline std::vector<Correspondence> spread(std::span<const Correspondence> samples, std::size_t count) {
  if (count >= samples.size()) return {samples.begin(), samples.end()};
  constexpr double kGoldenRatio = 0.6180339887498949;
  std::vector<Correspondence> chosen;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = static_cast<double>(i) * kGoldenRatio;
    chosen.push_back(samples[static_cast<std::size_t>((turn - std::floor(turn)) * static_cast<double>(samples.size()))]);
  }
  return chosen;
}

/// A fitted model M.
template <CameraModelType M>
struct Fit {
  std::array<double, kParameterCount<M>> parameters{};
  double rms_px = 0.0;
  int iterations = 0;
  bool reaches_all = true;  ///< Every sample projects.
  std::vector<std::string> at_bound;
};

/// Fits M to samples. Call it through fit_model().
template <CameraModelType M>
class Fitter {
  static constexpr int kCount = static_cast<int>(kParameterCount<M>);
  using Values = std::array<double, kParameterCount<M>>;
  using Jet = ceres::Jet<double, kCount>;

 public:
  Fitter(std::span<const Correspondence> samples, std::span<const ParameterRange> ranges) : samples_(samples) {
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      const Parameter& p = M::kParameters[i];
      // An open end of a model's range is not a camera, but what lies next to it may be the best one: eucm with beta -> 0 is
      // how a pinhole looks where alpha must be above 0.5.
      constexpr double kHair = 1e-6;
      lower_[i] = p.lower + (p.open ? kHair : 0.0);
      upper_[i] = p.upper - (p.open ? kHair : 0.0);
      held_[i] = held_in_fits<M>(p.name);
      for (const ParameterRange& range : ranges) {
        if (range.parameter != p.name) continue;
        held_[i] = false;
        lower_[i] = std::max(lower_[i], range.lower);
        upper_[i] = std::min(upper_[i], range.upper);
      }
    }
  }

  /// From a given camera.
  std::optional<Fit<M>> fit_from(const Values& start) {
    Candidate candidate;
    candidate.values = start;
    hold_fixed(candidate);
    if (!polish(candidate, kFullIterations)) return std::nullopt;
    respect_bounds(candidate);
    return finish(candidate);
  }

  /// That camera as it is, if it lies within the ranges.
  std::optional<Fit<M>> as_it_is(const Values& values) const {
    Candidate candidate;
    candidate.values = values;
    hold_fixed(candidate);
    if (candidate.values != values) return std::nullopt;
    return finish(candidate);
  }

  /// From the model's own starts, given the source's centre.
  std::optional<Fit<M>> fit(const LensCentre& centre) {
    std::optional<Candidate> best;
    const std::span<const Correspondence> all = samples_;
    const std::vector<Correspondence> few = spread(all, kCoarseSamples);
    for (int start = 0; start < M::kStarts; ++start) {
      Candidate candidate;
      M::initialise(all, centre, start, candidate.values.data());
      hold_fixed(candidate);
      samples_ = few;
      const bool usable = M::kStarts == 1 || polish(candidate, kCoarseIterations);
      samples_ = all;
      if (usable && (!best || candidate.cost < best->cost)) best = candidate;
    }
    if (!best || !polish(*best, kFullIterations)) return std::nullopt;
    respect_bounds(*best);
    return finish(*best);
  }

 private:
  struct Candidate {
    Values values{};
    std::array<bool, kParameterCount<M>> fixed{};
    double cost = 0.0;
    int iterations = 0;
  };
  static constexpr int kFullIterations = 200;
  /// Which basin is deeper shows late, and only on many points, where parameters are as many as rational's.
  static constexpr bool kManyParameters = kCount > 10;
  static constexpr int kCoarseIterations = kManyParameters ? 60 : 20;
  static constexpr std::size_t kCoarseSamples = kManyParameters ? 200 : 48;

  void hold_fixed(Candidate& candidate) const {
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      candidate.fixed[i] = held_[i] || lower_[i] == upper_[i];
      candidate.values[i] = std::clamp(candidate.values[i], lower_[i], upper_[i]);
    }
  }

  static bool evaluates(const Values& values, const Correspondence& s) {
    double pixel[2];
    return M::formula(values.data(), s.ray.data(), pixel) && std::isfinite(pixel[0]) && std::isfinite(pixel[1]);
  }

  /// A start may not reach every sample: fit those it reaches, then ask again with the better parameters.
  bool polish(Candidate& candidate, int max_iterations) {
    std::size_t before = 0;
    for (int round = 0; round < 4; ++round) {
      active_.clear();
      for (const Correspondence& s : samples_) {
        if (evaluates(candidate.values, s)) active_.push_back(s);
      }
      if (active_.size() * 2 < static_cast<std::size_t>(kCount) || (round > 0 && active_.size() <= before)) break;
      before = active_.size();
      if (!minimise_active(candidate, max_iterations)) return false;
      if (active_.size() == samples_.size()) break;
    }
    return before > 0;
  }

  bool minimise_active(Candidate& candidate, int max_iterations) {
    std::vector<double> free;
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      if (!candidate.fixed[i]) free.push_back(candidate.values[i]);
    }
    if (free.empty()) return true;
    const Residuals residuals_of = [&](const double* p, double* residuals, double* jacobian) {
      return this->evaluate(candidate, p, residuals, jacobian);
    };
    const Minimum minimum = minimise(residuals_of, static_cast<int>(2 * active_.size()), max_iterations, free);
    if (!minimum.usable) return false;
    candidate.cost = minimum.cost;
    candidate.iterations += minimum.iterations;
    candidate.values = merged(candidate, free.data());
    return true;
  }

  static Values merged(const Candidate& candidate, const double* free) {
    Values values = candidate.values;
    for (std::size_t i = 0, k = 0; i < kParameterCount<M>; ++i) {
      if (!candidate.fixed[i]) values[i] = free[k++];
    }
    return values;
  }

  /// Residuals in pixels, times the root of the sample's weight; derivatives with respect to the free parameters.
  bool evaluate(const Candidate& candidate, const double* free, double* residuals, double* jacobian) const {
    const Values values = merged(candidate, free);
    if (jacobian == nullptr) {
      for (const Correspondence& s : active_) {
        double pixel[2];
        if (!M::formula(values.data(), s.ray.data(), pixel)) return false;
        const double root = std::sqrt(s.weight);
        for (std::size_t axis = 0; axis < 2; ++axis) *residuals++ = root * (pixel[axis] - s.pixel[axis]);
      }
      return true;
    }
    std::array<Jet, kParameterCount<M>> parameters;
    int free_count = 0;
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      parameters[i] = Jet(values[i]);
      if (!candidate.fixed[i]) parameters[i].v[free_count++] = 1.0;
    }
    for (const Correspondence& s : active_) {
      const Jet ray[3] = {Jet(s.ray[0]), Jet(s.ray[1]), Jet(s.ray[2])};
      Jet pixel[2];
      if (!M::formula(parameters.data(), ray, pixel)) return false;
      const double root = std::sqrt(s.weight);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        *residuals++ = root * (pixel[axis].a - s.pixel[axis]);
        for (int k = 0; k < free_count; ++k) *jacobian++ = root * pixel[axis].v[k];
      }
    }
    return true;
  }

  /// While a parameter lies outside its range: put the one furthest outside on its bound, hold it there, fit the others again.
  void respect_bounds(Candidate& candidate) {
    for (int round = 0; round < kCount; ++round) {
      std::optional<std::size_t> worst;
      double furthest = 0.0;
      for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
        const double value = candidate.values[i];
        const double outside = std::max(lower_[i] - value, value - upper_[i]) / (1.0 + std::abs(value));
        if (!candidate.fixed[i] && outside > furthest) {
          furthest = outside;
          worst = i;
        }
      }
      if (!worst) return;
      candidate.values[*worst] = std::clamp(candidate.values[*worst], lower_[*worst], upper_[*worst]);
      candidate.fixed[*worst] = true;
      if (!polish(candidate, kFullIterations)) return;
    }
  }

  Fit<M> finish(const Candidate& candidate) const {
    Fit<M> result;
    result.parameters = candidate.values;
    result.iterations = candidate.iterations;
    double weight = 0.0;
    double sum = 0.0;
    for (const Correspondence& s : samples_) {
      double pixel[2];
      if (!M::project(candidate.values.data(), s.ray.data(), pixel)) {
        result.reaches_all = false;
        continue;
      }
      weight += s.weight;
      sum += s.weight * (std::pow(pixel[0] - s.pixel[0], 2) + std::pow(pixel[1] - s.pixel[1], 2));
    }
    result.rms_px = weight > 0.0 ? std::sqrt(sum / weight) : 0.0;
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      if (candidate.fixed[i] && !held_[i] && lower_[i] != upper_[i]) result.at_bound.emplace_back(M::kParameters[i].name);
    }
    return result;
  }

  std::span<const Correspondence> samples_;
  std::vector<Correspondence> active_;
  Values lower_{};
  Values upper_{};
  std::array<bool, kParameterCount<M>> held_{};
};

}  // namespace fca::internal
