// SPDX-License-Identifier: BSD-3-Clause
// Fits one camera model to samples, which are pairs of a ray and a pixel. The Fitter finds cameras that may be near the lowest
// minimum of the cost, and the Polisher (polisher.h) minimises the cost from each of them. These candidates come from
// - the model's linear starts, minimised on a few samples,
// - a search over the model's shape (FitTarget::shapes), for a model that has one,
// - the other side of the fold (FitTarget::folded), for a model that has one.
// A model has a shape if it is linear in all other parameters once this one and fy / fx are given. A model has a fold if there
// is a parameter along which two minima with nearly the same pixels exist, one on each side of the fold. README.md describes
// the method.
#pragma once

#include "polisher.h"

#include <fca/convert/fit_target.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// Chooses `count` of the samples, or all if there are fewer. Their indices are the fractional parts of multiples of the golden
/// ratio, times the number of samples. The samples are ordered by rows: a constant stride would choose the same few radii again
/// and again.
[[nodiscard]] std::vector<Correspondence> choose_evenly(std::span<const Correspondence> samples, std::size_t count);

/// Fits one model to one set of samples.
class Fitter {
 public:
  /// `target` and `samples` must outlive the Fitter.
  Fitter(const FitTarget& target, std::span<const Correspondence> samples, std::span<const ParameterRange> ranges);

  /// Fits from the model's own starts. `centre` holds the source's central focal lengths and principal point. nullopt if no
  /// start leads to a camera.
  std::optional<FoundFit> fit(const LensCentre& centre);
  /// Fits from a given camera. nullopt if it cannot be evaluated, or the result has a pixel for no sample.
  std::optional<FoundFit> fit_from(const ParameterValues& start);
  /// Like fit_from(), but solves a linear model directly, which needs no start. The solution then uses `centre` only to scale
  /// and shift the pixels.
  std::optional<FoundFit> refit(const ParameterValues& start, const LensCentre& centre);
  /// Returns the given camera unchanged, with its rms [px] on the samples. nullopt if a parameter is outside its range, or the
  /// camera has a pixel for no sample.
  [[nodiscard]] std::optional<FoundFit> evaluate_camera(const ParameterValues& values) const;

 private:
  [[nodiscard]] std::optional<FoundFit> solve(const LensCentre& centre) const;
  void polish_all(std::vector<Candidate>& candidates, std::optional<FoundFit>& best);
  [[nodiscard]] bool is_across_fold(const Candidate& candidate, const std::vector<Candidate>& polished) const;
  bool move_inside(Candidate& candidate) const;
  std::optional<FoundFit> fit_starts(const LensCentre& centre);
  std::vector<Candidate> coarse_fits(const LensCentre& centre);
  void search_across_fold(std::size_t folded, std::vector<Candidate>& polished, const Effort& effort);
  double cost_of_start(const ParameterValues& values);
  bool was_tried(double cost);
  [[nodiscard]] std::optional<Candidate> fit_terms(std::span<const Correspondence> samples, const LensCentre& centre,
                                                   double shape) const;
  struct Trial;
  [[nodiscard]] std::vector<Trial> try_shapes(std::span<const Correspondence> few, const LensCentre& centre) const;
  [[nodiscard]] Trial refine_minimum(std::span<const Trial> trials, std::size_t index, std::span<const Correspondence> few,
                                     const LensCentre& centre) const;
  std::vector<Candidate> search_shapes(const LensCentre& centre);
  void rank_rivals(const LensCentre& centre, std::vector<Trial>& found) const;

  const FitTarget& target_;
  std::size_t parameter_count_;
  Effort full_effort_;               ///< Effort of a fit to all samples.
  std::vector<double> tried_costs_;  ///< Costs [px^2] of the starts tried so far.
  /// A start with a cost above this multiple of the best start's cost is not polished, since it is probably far from the lowest
  /// minimum. The limit becomes infinite when the best fit from the first starts is not good enough.
  double max_start_cost_ratio_ = 400.0;
  std::span<const Correspondence> samples_;  ///< All samples; a few of them during coarse_fits().
  std::vector<std::array<double, 2>> pixels_;
  Polisher polisher_;
};

}  // namespace fca::internal
