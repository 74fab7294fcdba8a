// SPDX-License-Identifier: BSD-3-Clause
// Fits one camera model to rays and pixels: linear starts, then Levenberg-Marquardt on the geometric residual (pixels), bounds
// by taking the active parameter out of the step. Whether the fitted camera folds inside the samples is asked afterwards. A
// template over the model concept: works for any model, listed or not.
#pragma once

#include "aspect_fit.h"
#include "fit_limits.h"
#include "linearised.h"
#include "minimise.h"
#include "orthonormal.h"

#include <fca/convert/convert.h>
#include <fca/models/model_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

/// A model that is linear once fy / fx is given (model_traits.h).
template <class M>
concept HasTerms = requires(const double* in, const std::array<double, 2>& point, double* out) {
  { M::kTerms } -> std::convertible_to<std::size_t>;
  { M::terms(in, out, out) } -> std::same_as<bool>;
  { M::from_terms(in, double{}, point, out) } -> std::same_as<void>;
};

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

 public:
  Fitter(std::span<const Correspondence> samples, std::span<const ParameterRange> ranges) : samples_(samples) {
    const Limits<M> limits = limits_of<M>(ranges);
    lower_ = limits.lower;
    upper_ = limits.upper;
    held_ = limits.held;
  }

  /// From a given camera.
  std::optional<Fit<M>> fit_from(const Values& start) {
    Candidate candidate;
    candidate.values = start;
    hold_fixed(candidate);
    if (!polish(candidate, kFull)) return std::nullopt;
    respect_bounds(candidate);
    return finish(candidate);
  }

  /// That camera as it is, if it lies within the ranges.
  std::optional<Fit<M>> as_it_is(const Values& values) const {
    Candidate candidate;
    candidate.values = values;
    candidate.on_all = false;  // there is no cost yet
    hold_fixed(candidate);
    if (candidate.values != values) return std::nullopt;
    return finish(candidate);
  }

  /// From the model's own starts, given the source's centre.
  std::optional<Fit<M>> fit(const LensCentre& centre) {
    if constexpr (HasTerms<M>) {
      if (const std::optional<Candidate> candidate = fit_terms(centre)) return finish(*candidate);
    }
    std::optional<Fit<M>> best;
    std::vector<Candidate> candidates = coarse_fits(centre);
    if (candidates.empty()) return std::nullopt;
    polish_all(candidates, best);
    if constexpr (requires { M::kFolded; }) {
      // Close to the fold a few samples do not tell its sides apart.
      if (best && !settled(*best) && best->at_bound.empty()) {
        Candidate found = candidates.front();
        found.values = best->parameters;
        found.cost = best->rms_px * best->rms_px;
        std::vector<Candidate> beyond = {found};
        look_beyond_fold(beyond, kFull);
        std::ranges::sort(beyond, {}, &Candidate::cost);
        polish_all(beyond, best);
      }
    }
    return best;
  }

 private:
  struct Candidate {
    Values values{};
    std::array<bool, kParameterCount<M>> fixed{};
    double cost = 0.0;
    int iterations = 0;
    bool on_all = true;  ///< The cost is that of all samples.
  };
  /// Whoever looks at a thousandth of the error looks at a millionth of its square.
  static constexpr Effort kFull{200, 1e-9};
  /// Which basin is deeper shows late, and only on many points, where parameters are as many as rational's.
  static constexpr bool kManyParameters = kCount > 10;
  static constexpr Effort kCoarse = kManyParameters ? Effort{60, 1e-6} : Effort{30, 1e-4};
  static constexpr std::size_t kCoarseSamples = kManyParameters ? 100 : 32;

  /// Below this, in px^2, what is left is worth a second look; below that, there is nothing.
  static constexpr double kSmallCost = 1e-6;
  static constexpr double kExactCost = 1e-22;
  static constexpr double kKnown = 1e-8;  ///< Of another bottom's cost: this one is the lens.
  static constexpr double kWorthwhile = 0.9;

  void hold_fixed(Candidate& candidate) const {
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      candidate.fixed[i] = held_[i] || lower_[i] == upper_[i];
      candidate.values[i] = std::clamp(candidate.values[i], lower_[i], upper_[i]);
    }
  }

  /// Fits from the candidates until no other can be better.
  void polish_all(std::vector<Candidate>& candidates, std::optional<Fit<M>>& best) {
    for (Candidate& candidate : candidates) {
      if (!polish(candidate, kFull)) continue;
      respect_bounds(candidate);
      keep_better(finish(candidate), best);
      if (move_inside(candidate) && polish(candidate, kFull)) {
        respect_bounds(candidate);
        keep_better(finish(candidate), best);
      }
      if (settled(*best)) return;
    }
  }

  static void keep_better(Fit<M> fit, std::optional<Fit<M>>& best) {
    const bool better = !best || (fit.reaches_all != best->reaches_all ? fit.reaches_all : fit.rms_px < best->rms_px);
    if (better) best = std::move(fit);
  }

  /// Would no other start be better? One may be where a parameter ends at a bound, as the basin's bottom lies beyond it; and
  /// where next to nothing is left, but not nothing: then another basin holds the very lens, and looked as good on few samples.
  static bool settled(const Fit<M>& fit) {
    const double cost = fit.rms_px * fit.rms_px;
    return fit.at_bound.empty() && fit.reaches_all && !(cost > kExactCost && cost < kSmallCost);
  }

  /// From a bound that holds parameters a little way back inside, where they may find a bottom of their own. False if none is
  /// held.
  bool move_inside(Candidate& candidate) const {
    constexpr double kALittle = 0.05;
    bool moved = false;
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      if (!candidate.fixed[i] || held_[i] || lower_[i] == upper_[i]) continue;
      double& value = candidate.values[i];
      const double inside = value + (value == lower_[i] ? kALittle : -kALittle);
      value = std::clamp(inside, lower_[i], upper_[i]);
      candidate.fixed[i] = false;
      moved = true;
    }
    return moved;
  }

  /// The model's starts, polished on a few of the samples, best first.
  std::vector<Candidate> coarse_fits(const LensCentre& centre) {
    const std::span<const Correspondence> all = samples_;
    const std::vector<Correspondence> few = spread(all, kCoarseSamples);
    samples_ = few;
    std::vector<Candidate> starts;
    for (int i = 0; i < M::kStarts; ++i) {
      Candidate& start = starts.emplace_back();
      M::initialise(few, centre, i, start.values.data());
      hold_fixed(start);
      start.cost = cost_of_start(start.values);
    }
    std::ranges::sort(starts, {}, &Candidate::cost);
    std::vector<Candidate> polished;
    const double first_cost = starts.front().cost;
    for (Candidate& start : starts) {
      // Far worse than the best start: not even the right basin's edge.
      constexpr double kHopeless = 400.0;
      if (!polished.empty() && start.cost > kHopeless * first_cost) break;
      if (!polish(start, kCoarse)) continue;
      polished.push_back(start);
      if (start.on_all && start.cost < kExactCost) break;
    }
    std::ranges::sort(polished, {}, &Candidate::cost);
    if constexpr (requires { M::kFolded; }) {
      if (!polished.empty()) {
        look_beyond_fold(polished, kCoarse);
        std::ranges::sort(polished, {}, &Candidate::cost);
      }
    }
    samples_ = all;
    return polished;
  }

  /// A model with a fold has two bottoms that differ by little, one on each side of it. Along the valley, where the folded
  /// parameter is set and the others follow, the way leads across.
  void look_beyond_fold(std::vector<Candidate>& polished, const Effort& effort) {
    constexpr double kNearlyExact = 1e-3;  // px^2: worse, and no lens of this model is behind the samples
    // The most likely ones first; the others where a lens of this model seems to be.
    constexpr std::array kSteps = {0.15, -0.15, 0.4, -0.4, 0.06, -0.06, 0.02, -0.02, 0.1, -0.1, 0.03, -0.03, 0.7, -0.7};
    constexpr std::size_t kLikely = 2;
    const Candidate from = polished.front();
    if (!from.on_all || from.cost > kNearlyExact) return;
    const double exact = std::max(kExactCost, kKnown * from.cost);
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      if (polished.back().cost <= exact || from.cost <= kExactCost) return;
      if (i >= kLikely && from.cost > kSmallCost) return;
      Candidate candidate = from;
      double& folded = candidate.values[M::kFolded];
      if (candidate.fixed[M::kFolded] || !(folded + kSteps[i] > lower_[M::kFolded])) continue;
      folded += kSteps[i];
      candidate.fixed[M::kFolded] = true;
      const bool followed = polish(candidate, effort);
      candidate.fixed[M::kFolded] = false;
      if (followed && polish(candidate, effort)) polished.push_back(candidate);
    }
  }

  /// Mean squared distance, one that is missed counting as much as a wide image.
  double cost_of_start(const Values& values) const {
    constexpr double kMissed = 1e6;  // px^2
    double cost = 0.0;
    for (const Correspondence& s : samples_) {
      double pixel[2];
      const bool seen = M::formula(values.data(), s.ray.data(), pixel);
      const double du = pixel[0] - s.pixel[0];
      const double dv = pixel[1] - s.pixel[1];
      const double squared = seen ? du * du + dv * dv : kMissed;
      cost += s.weight * (squared < kMissed ? squared : kMissed);
    }
    return cost;
  }

  /// Without a start, where no range of a parameter gets in the way.
  std::optional<Candidate> fit_terms(const LensCentre& centre) requires HasTerms<M> {
    Candidate candidate;
    if (std::ranges::any_of(held_, std::identity{})) return std::nullopt;
    AspectFit fit(M::kTerms, samples_.size());
    std::size_t points = 0;
    for (const Correspondence& s : samples_) {
      double along_u[M::kTerms];
      double along_v[M::kTerms];
      if (!M::terms(s.ray.data(), along_u, along_v)) return std::nullopt;
      fit.set(points++, along_u, along_v, {s.pixel[0] - centre.point[0], s.pixel[1] - centre.point[1]}, s.weight);
    }
    const std::optional<AspectFit::Solution> solution = fit.solve(centre.focal[1] / centre.focal[0]);
    if (!solution) return std::nullopt;
    const std::array<double, 2> point = {centre.point[0] + solution->point[0], centre.point[1] + solution->point[1]};
    M::from_terms(solution->coefficients.data(), solution->aspect, point, candidate.values.data());
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      if (!(candidate.values[i] >= lower_[i] && candidate.values[i] <= upper_[i])) return std::nullopt;
    }
    candidate.cost = solution->cost;
    candidate.iterations = solution->iterations;
    return candidate;
  }

  static bool evaluates(const Values& values, const Correspondence& s) {
    double pixel[2];
    return M::formula(values.data(), s.ray.data(), pixel) && std::isfinite(pixel[0]) && std::isfinite(pixel[1]);
  }

  /// A start may not reach every sample: fit those it reaches, then ask again with the better parameters.
  bool polish(Candidate& candidate, const Effort& effort) {
    std::size_t before = 0;
    for (int round = 0; round < 4; ++round) {
      std::vector<Correspondence> active;
      for (const Correspondence& s : samples_) {
        if (evaluates(candidate.values, s)) active.push_back(s);
      }
      if (active.size() * 2 < static_cast<std::size_t>(kCount) || (round > 0 && active.size() <= before)) break;
      before = active.size();
      linearised_.reset(std::move(active), candidate.fixed);
      if (!minimise_active(candidate, effort)) return false;
      if (before == samples_.size()) break;
    }
    return before > 0;
  }

  bool minimise_active(Candidate& candidate, const Effort& effort) {
    std::array<double, kParameterCount<M>> free{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      if (!candidate.fixed[i]) free[count++] = candidate.values[i];
    }
    if (count == 0) {
      candidate.on_all = false;
      return true;
    }
    const Evaluate evaluate_at = [this, &candidate](const double* p, NormalEquations& sums) {
      return linearised_.evaluate(merged(candidate, p), sums);
    };
    const Minimum minimum = minimise(evaluate_at, effort, std::span(free).first(count));
    if (!minimum.usable) return false;
    candidate.cost = minimum.cost;
    candidate.iterations += minimum.iterations;
    candidate.on_all = linearised_.rows() == 2 * samples_.size();
    if (minimum.cost < kSmallCost) refine(candidate, effort, std::span(free).first(count));
    candidate.values = merged(candidate, free.data());
    return true;
  }

  /// The same in coordinates in which the Jacobian's columns are orthonormal at the start: J'J squares the condition of J, and
  /// where next to nothing is left to gain, in a valley, the way is lost in its rounding. Again while that helps, because the
  /// coordinates are those of one point.
  void refine(Candidate& candidate, const Effort& effort, std::span<double> free) {
    constexpr int kMostRounds = 8;
    for (int round = 0; round < kMostRounds && candidate.cost > kExactCost; ++round) {
      if (!linearised_.linearise(merged(candidate, free.data()))) return;
      orthonormal_.reset(linearised_.rows(), linearised_.columns().size());
      for (const Column& column : linearised_.columns()) orthonormal_.add(column.data);
      const Values centre = [&] {
        Values values{};
        std::ranges::copy(free, values.begin());
        return values;
      }();
      const auto free_at = [&](const double* y) {
        Values values = centre;
        orthonormal_.step(y, values.data());
        return values;
      };
      const Evaluate evaluate_at = [&](const double* y, NormalEquations& sums) {
        const Values values = merged(candidate, free_at(y).data());
        if (sums.gradient.empty()) return linearised_.evaluate(values, sums);
        if (!linearised_.linearise(values)) return false;
        orthonormal_.transform(linearised_.columns(), moved_);
        const Column r = linearised_.residuals();
        products(std::span(&r, 1), r, &sums.cost);
        products(orthonormal_.columns(moved_), r, sums.gradient.data());
        products(orthonormal_.columns(moved_), sums.hessian.data());
        return true;
      };
      Values y{};
      const Minimum minimum = minimise(evaluate_at, effort, std::span(y).first(free.size()));
      if (!minimum.usable || !(minimum.cost < candidate.cost)) return;
      std::copy_n(free_at(y.data()).begin(), free.size(), free.begin());
      const bool helps = minimum.cost < kWorthwhile * candidate.cost;
      candidate.cost = minimum.cost;
      candidate.iterations += minimum.iterations;
      if (!helps) return;
    }
  }

  static Values merged(const Candidate& candidate, const double* free) {
    Values values = candidate.values;
    for (std::size_t i = 0, k = 0; i < kParameterCount<M>; ++i) {
      if (!candidate.fixed[i]) values[i] = free[k++];
    }
    return values;
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
      if (!polish(candidate, kFull)) return;
    }
  }

  /// How far from the samples, and whether all of them are in the model's domain.
  void score(const Candidate& candidate, Fit<M>& result) const {
    double weight = 0.0;
    double lowest = 1.0;
    for (const Correspondence& s : samples_) {
      weight += s.weight;
      lowest = std::min(lowest, s.ray[2]);
    }
    // The fit knows the distances; the domain's limit, an angle, decides for all rays at once, unless it is too close to tell.
    constexpr double kHair = 1e-9;
    if (candidate.on_all && lowest > std::cos(M::max_angle(candidate.values.data())) + kHair) {
      result.rms_px = std::sqrt(candidate.cost / weight);
      return;
    }
    weight = 0.0;
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
  }

  Fit<M> finish(const Candidate& candidate) const {
    Fit<M> result;
    result.parameters = candidate.values;
    result.iterations = candidate.iterations;
    score(candidate, result);
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      if (candidate.fixed[i] && !held_[i] && lower_[i] != upper_[i]) result.at_bound.emplace_back(M::kParameters[i].name);
    }
    return result;
  }

  std::span<const Correspondence> samples_;
  Linearised<M> linearised_;
  std::vector<double> moved_;  ///< The Jacobian in other coordinates.
  Orthonormal orthonormal_;
  Values lower_{};
  Values upper_{};
  std::array<bool, kParameterCount<M>> held_{};
};

}  // namespace fca::internal
