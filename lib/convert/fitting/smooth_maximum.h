// SPDX-License-Identifier: BSD-3-Clause
// Minimises the largest error of a set of points over a few parameters within bounds.
//
// The smooth function (1/m) log sum exp(m s_k) replaces the largest of the squared errors s_k (Kreisselmeier and Steinhauser
// 1979). It exceeds the largest by at most log(number of points) / m. A damped Newton method minimises the smooth function for
// increasing values of the sharpness m (Xu, "Smoothing method for minimax problems", 2001). Like the Gauss-Newton method, it
// neglects the second derivatives of the residuals.
#pragma once

#include "normal_equations.h"

#include <cstddef>
#include <span>

namespace fca::internal {

struct WeightedPoint {
  std::size_t index = 0;  ///< Index in PointErrors.
  double weight = 0.0;
};

/// Residuals [px] of points and their derivatives. The rows are those of u for all points, then those of v, each times the
/// square root of the point's weight.
struct LinearErrors {
  std::span<const Column> columns;  ///< The derivatives with respect to the free parameters, one column per parameter.
  Column residuals;
};

/// The errors of a set of points as a function of the parameters.
class PointErrors {
 public:
  PointErrors() = default;
  virtual ~PointErrors() = default;
  PointErrors(const PointErrors&) = delete;
  PointErrors& operator=(const PointErrors&) = delete;

  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Writes the squared error [px^2] of every point to `result`. False if a point has no error, as when its ray has no pixel.
  /// The minimisation then rejects these parameters.
  virtual bool squares(std::span<const double> values, std::span<double> result) = 0;
  /// Computes residuals and derivatives of the given points. `result` is valid until the next call. False if a point has none.
  virtual bool compute_jacobian(std::span<const double> values, std::span<const WeightedPoint> points,
                                LinearErrors& result) = 0;
};

/// A parameter that the minimisation may change.
struct FreeParameter {
  std::size_t index = 0;  ///< Index among all parameters.
  double lower = 0.0;
  double upper = 0.0;
};

/// First values of the sharpness m. With a low sharpness all points influence the first steps; with a high one only the worst
/// points do, which suits a start that is already close to the minimum.
inline constexpr double kLowSharpness = 8.0;
inline constexpr double kHighSharpness = 64.0;

/// Changes the free parameters in `values` (all parameters) so that the largest error becomes as small as possible. They must
/// be within their bounds at the start and stay within them. `free` has the order of LinearErrors::columns. Returns the number
/// of steps.
int minimise_maximum(PointErrors& errors, std::span<const FreeParameter> free, double first_sharpness,
                     std::span<double> values);

}  // namespace fca::internal
