// SPDX-License-Identifier: BSD-3-Clause
// Fits one camera model to rays and pixels: finds the basins that may hold the best camera (linear starts, coarse polishes, a
// search along a shape, the other side of a fold) and polishes in those.
#pragma once

#include "polisher.h"

#include <fca/convert/fit_target.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// `count` of the samples (all, if there are no more), spread by the golden ratio: a stride would pick the same radii again and
/// again from samples that come in rows.
[[nodiscard]] std::vector<Correspondence> spread(std::span<const Correspondence> samples, std::size_t count);

class Fitter {
 public:
  /// Target and samples must outlive it.
  Fitter(const FitTarget& target, std::span<const Correspondence> samples, std::span<const ParameterRange> ranges);

  /// From the model's own starts, given the source's centre.
  std::optional<FoundFit> fit(const LensCentre& centre);
  /// From a given camera.
  std::optional<FoundFit> fit_from(const ParameterValues& start);
  /// The same where nothing depends on the start: a linear model is solved for, with that centre as the unit and the origin.
  std::optional<FoundFit> refit(const ParameterValues& start, const LensCentre& centre);
  /// That camera as it is, if it lies within the ranges.
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
  [[nodiscard]] Trial bottom_near(std::span<const Trial> trials, std::size_t at_trial, std::span<const Correspondence> few,
                                  const LensCentre& centre) const;
  std::vector<Candidate> search_shapes(const LensCentre& centre);
  void rank_rivals(const LensCentre& centre, std::vector<Trial>& found) const;

  const FitTarget& target_;
  std::size_t count_;          ///< Of parameters.
  Effort full_;                ///< Of a fit to all samples.
  std::vector<double> tried_;  ///< The costs of the starts.
  /// A start that is so many times worse than the best one is not even the right basin's edge; if that basin does not do, it is
  /// tried all the same.
  double hopeless_ = 400.0;
  std::span<const Correspondence> samples_;
  std::vector<std::array<double, 2>> pixels_;
  Polisher polisher_;
};

}  // namespace fca::internal
