// SPDX-License-Identifier: BSD-3-Clause
// Minimises from one start to the nearest minimum: Levenberg-Marquardt on pixel residuals. A parameter outside its bounds is
// put on the bound and held. Whether the resulting camera folds inside the samples is checked afterwards.
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

/// Mean squares [px^2]. A cost below kSmallCost is refined further; one below kExactCost counts as 0.
inline constexpr double kSmallCost = 1e-6;
inline constexpr double kExactCost = 1e-22;

/// With as many parameters as rational has, it shows late, and only on many samples, which minimum is lower.
inline constexpr std::size_t kManyParameters = 11;
[[nodiscard]] inline bool has_many_parameters(const FitTarget& target) { return target.parameters().size() >= kManyParameters; }

/// A camera during a fit.
struct Candidate {
  ParameterValues values{};
  std::array<bool, kMostParameters> fixed{};
  double cost = 0.0;
  int iterations = 0;
  bool on_all = true;     ///< False if the cost [px^2] leaves out samples without a pixel, or was not computed.
  bool is_rival = false;  ///< Its cost is close to that of the best other minimum, so that it must be polished too.
};

class Polisher {
 public:
  /// `target` must outlive the Polisher.
  Polisher(const FitTarget& target, std::span<const ParameterRange> ranges);

  [[nodiscard]] const FitLimits& limits() const { return limits_; }

  /// Marks the parameters that the ranges fix, and moves all values into their ranges.
  void hold_fixed(Candidate& candidate) const;
  /// Minimises without regard to bounds. False if the start cannot be evaluated, or too few samples have pixels.
  bool polish(Candidate& candidate, std::span<const Correspondence> samples, const Effort& effort);
  /// Moves parameters outside their bounds onto these and minimises over the others.
  void respect_bounds(Candidate& candidate, std::span<const Correspondence> samples, const Effort& effort);
  /// The result, with its rms over the samples; nullopt if no sample has a pixel.
  [[nodiscard]] std::optional<FoundFit> finish(const Candidate& candidate, std::span<const Correspondence> samples) const;

 private:
  bool minimise_active(Candidate& candidate, std::size_t samples, const Effort& effort);
  Minimum minimise_free(const Candidate& candidate, const Effort& effort, std::span<double> free);
  Minimum minimise_shape(const Candidate& candidate, const Effort& effort, std::span<double> free);
  void refine(Candidate& candidate, const Effort& effort, std::span<double> free);
  [[nodiscard]] ParameterValues merged(const Candidate& candidate, const double* free) const;
  [[nodiscard]] bool score(const Candidate& candidate, std::span<const Correspondence> samples, FoundFit& result) const;

  const FitTarget& target_;
  std::size_t count_;  ///< Number of parameters.
  SampleJacobian jacobian_;
  std::vector<std::array<double, 2>> pixels_;
  std::vector<double> moved_;  ///< The Jacobian in the coordinates of qr_.
  QrDecomposition qr_;
  FitLimits limits_;
};

}  // namespace fca::internal
