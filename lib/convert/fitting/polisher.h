// SPDX-License-Identifier: BSD-3-Clause
// Minimises the squared pixel errors from one start to a nearby minimum by the Levenberg-Marquardt method. A parameter that
// leaves its range is moved to the bound and fixed there. The minimisation uses the model's formula beyond the model's domain;
// only finish() checks whether the samples are inside the domain.
#pragma once

#include "fit_limits.h"
#include "minimise.h"
#include "qr_decomposition.h"
#include "sample_jacobian.h"

#include <fca/convert/fit_target.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// Costs [px^2]. The cost over all samples of a fit is a mean square, since their weights sum to 1. A minimum with a cost below
/// kSmallCost is refined (Polisher::refine). A cost below kExactCost is only rounding error.
inline constexpr double kSmallCost = 1e-6;
inline constexpr double kExactCost = 1e-22;

/// A model with at least this many parameters (rational) has many minima, and only a long fit to many samples shows which is
/// the lowest.
inline constexpr std::size_t kManyParameters = 11;
[[nodiscard]] inline bool has_many_parameters(const FitTarget& target) { return target.parameters().size() >= kManyParameters; }

/// A camera during a fit.
struct Candidate {
  ParameterValues values{};
  std::array<bool, kMostParameters> fixed{};  ///< True if the minimisation must not change the parameter.
  double cost = 0.0;                          ///< Weighted sum of the squared pixel errors [px^2].
  int iterations = 0;
  bool cost_is_complete = true;  ///< False if some samples have no pixel, so that the cost omits them, or if there is no cost.
  bool is_rival = false;         ///< True if the candidate must be polished on all samples even when a good fit is known.
};

/// Minimises from candidates of one model. An object keeps its memory between calls.
class Polisher {
 public:
  /// `target` must outlive the Polisher.
  Polisher(const FitTarget& target, std::span<const ParameterRange> ranges);

  [[nodiscard]] const FitLimits& limits() const { return limits_; }

  /// Marks the parameters that the limits fix as fixed, the others as free, and moves all values into their ranges.
  void apply_ranges(Candidate& candidate) const;
  /// Minimises over the candidate's free parameters, which may leave their ranges. False if the start cannot be evaluated, or
  /// too few samples have pixels.
  bool polish(Candidate& candidate, std::span<const Correspondence> samples, const Effort& effort);
  /// Moves free parameters that are outside their ranges to the bounds, fixes them there and minimises over the others.
  void respect_bounds(Candidate& candidate, std::span<const Correspondence> samples, const Effort& effort);
  /// Returns the candidate as a fit, with its rms [px] over the samples. nullopt if no sample has a pixel in the model's
  /// domain.
  [[nodiscard]] std::optional<FoundFit> finish(const Candidate& candidate, std::span<const Correspondence> samples) const;

 private:
  bool minimise_active(Candidate& candidate, std::size_t samples, const Effort& effort);
  Minimum minimise_free(const Candidate& candidate, const Effort& effort, std::span<double> free);
  Minimum minimise_shape(const Candidate& candidate, const Effort& effort, std::span<double> free);
  void refine(Candidate& candidate, const Effort& effort, std::span<double> free);
  [[nodiscard]] ParameterValues merged(const Candidate& candidate, const double* free) const;
  [[nodiscard]] bool score(const Candidate& candidate, std::span<const Correspondence> samples, FoundFit& result) const;

  const FitTarget& target_;
  std::size_t parameter_count_;
  SampleJacobian jacobian_;
  std::vector<std::array<double, 2>> pixels_;
  std::vector<double> transformed_;  ///< The Jacobian in the coordinates of qr_.
  QrDecomposition qr_;
  FitLimits limits_;
};

}  // namespace fca::internal
