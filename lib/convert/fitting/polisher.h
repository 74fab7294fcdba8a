// SPDX-License-Identifier: BSD-3-Clause
// From one start to the bottom of its basin: Levenberg-Marquardt on the geometric residual (pixels), bounds by taking the
// active parameter out of the step. Whether the camera at the bottom folds inside the samples is asked afterwards.
#pragma once

#include "fit_limits.h"
#include "linearised.h"
#include "minimise.h"
#include "orthonormal.h"

#include <fca/convert/fit_target.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// Below this, in px^2, what is left is worth a second look; below that, there is nothing.
inline constexpr double kSmallCost = 1e-6;
inline constexpr double kExactCost = 1e-22;

/// Which basin is deeper shows late, and only on many points, where parameters are as many as rational's.
inline constexpr std::size_t kManyParameters = 11;
[[nodiscard]] inline bool has_many_parameters(const FitTarget& target) { return target.parameters().size() >= kManyParameters; }

/// A camera on its way.
struct Candidate {
  ParameterValues values{};
  std::array<bool, kMostParameters> fixed{};
  double cost = 0.0;
  int iterations = 0;
  bool on_all = true;     ///< The cost is that of all samples.
  bool is_rival = false;  ///< Of another bottom along a shape, about as deep as the deepest.
};

class Polisher {
 public:
  /// The target must outlive it.
  Polisher(const FitTarget& target, std::span<const ParameterRange> ranges);

  [[nodiscard]] const FitLimits& limits() const { return limits_; }

  /// Holds what the ranges fix, and puts the other parameters into theirs.
  void hold_fixed(Candidate& candidate) const;
  /// To the bottom, whatever the bounds; false if there is no way.
  bool polish(Candidate& candidate, std::span<const Correspondence> samples, const Effort& effort);
  /// Back inside the bounds, the others polished again.
  void respect_bounds(Candidate& candidate, std::span<const Correspondence> samples, const Effort& effort);
  /// Nothing if it reaches none of the samples.
  [[nodiscard]] std::optional<FoundFit> finish(const Candidate& candidate, std::span<const Correspondence> samples) const;

 private:
  bool minimise_active(Candidate& candidate, std::size_t samples, const Effort& effort);
  Minimum minimise_free(const Candidate& candidate, const Effort& effort, std::span<double> free);
  Minimum minimise_shape(const Candidate& candidate, const Effort& effort, std::span<double> free);
  void refine(Candidate& candidate, const Effort& effort, std::span<double> free);
  [[nodiscard]] ParameterValues merged(const Candidate& candidate, const double* free) const;
  [[nodiscard]] bool score(const Candidate& candidate, std::span<const Correspondence> samples, FoundFit& result) const;

  const FitTarget& target_;
  std::size_t count_;  ///< Of parameters.
  Linearised linearised_;
  std::vector<std::array<double, 2>> pixels_;
  std::vector<double> moved_;  ///< The Jacobian in other coordinates.
  Orthonormal orthonormal_;
  FitLimits limits_;
};

}  // namespace fca::internal
