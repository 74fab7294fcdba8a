// SPDX-License-Identifier: BSD-3-Clause
// Fits one camera model to rays and pixels. Finds candidates for the lowest minimum (linear starts, coarse polishes, a search
// along a shape, the other side of a fold) and polishes these.
#pragma once

#include "polisher.h"

#include <fca/convert/fit_target.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// Chooses `count` of the samples, or all if there are fewer, by multiples of the golden ratio. The samples come in rows; every
/// n-th one would have the same few radii.
[[nodiscard]] std::vector<Correspondence> spread(std::span<const Correspondence> samples, std::size_t count);

class Fitter {
 public:
  /// `target` and `samples` must outlive the Fitter.
  Fitter(const FitTarget& target, std::span<const Correspondence> samples, std::span<const ParameterRange> ranges);

  /// Fits from the model's own starts, given the source's centre. nullopt if no start leads to a camera.
  std::optional<FoundFit> fit(const LensCentre& centre);
  /// Fits from a given camera; nullopt if that fails.
  std::optional<FoundFit> fit_from(const ParameterValues& start);
  /// Like fit_from(), but solves a linear model directly, which needs no start; `centre` is then the scale and the origin of
  /// the pixels.
  std::optional<FoundFit> refit(const ParameterValues& start, const LensCentre& centre);
  /// The given camera with its rms on the samples; nullopt if it lies outside the ranges or reaches no sample.
  [[nodiscard]] std::optional<FoundFit> as_it_is(const ParameterValues& values) const;

 private:
  [[nodiscard]] std::optional<FoundFit> solve(const LensCentre& centre) const;
  void polish_all(std::vector<Candidate>& candidates, std::optional<FoundFit>& best);
  [[nodiscard]] bool is_across_fold(const Candidate& candidate, const std::vector<Candidate>& polished) const;
  bool move_inside(Candidate& candidate) const;
  std::optional<FoundFit> fit_starts(const LensCentre& centre);
  std::vector<Candidate> coarse_fits(const LensCentre& centre);
  void look_beyond_fold(std::size_t folded, std::vector<Candidate>& polished, const Effort& effort);
  double cost_of_start(const ParameterValues& values);
  bool is_known(double cost);
  [[nodiscard]] std::optional<Candidate> fit_terms(std::span<const Correspondence> samples, const LensCentre& centre,
                                                   double shape) const;
  struct Trial;
  [[nodiscard]] std::vector<Trial> try_shapes(std::span<const Correspondence> few, const LensCentre& centre) const;
  [[nodiscard]] Trial refine_minimum(std::span<const Trial> trials, std::size_t at_trial, std::span<const Correspondence> few,
                                     const LensCentre& centre) const;
  std::vector<Candidate> search_shapes(const LensCentre& centre);
  void rank_rivals(const LensCentre& centre, std::vector<Trial>& found) const;

  const FitTarget& target_;
  std::size_t count_;          ///< Number of parameters.
  Effort full_;                ///< Effort of a fit to all samples.
  std::vector<double> tried_;  ///< Costs [px^2] of the starts tried so far.
  /// A start whose cost is more than this multiple of the best start's is not polished: it is probably not even near the right
  /// minimum. Infinite once the best minimum has turned out not to be good enough.
  double hopeless_ = 400.0;
  std::span<const Correspondence> samples_;
  std::vector<std::array<double, 2>> pixels_;
  Polisher polisher_;
};

}  // namespace fca::internal
