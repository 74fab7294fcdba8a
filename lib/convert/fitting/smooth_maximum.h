// SPDX-License-Identifier: BSD-3-Clause
// Minimises the largest error of a set of points over a few parameters within bounds.
//
// The largest of the squared errors s_k is replaced by the smooth function (1/m) log sum exp(m s_k) (Kreisselmeier and
// Steinhauser 1979), which exceeds it by at most log(points) / m. A damped Newton method minimises that for increasing
// sharpness m (Xu, "Smoothing method for minimax problems", 2001). As in the Gauss-Newton method, second derivatives of the
// residuals are neglected.
#pragma once

#include "normal_equations.h"

#include <cstddef>
#include <span>

namespace fca::internal {

struct WeightedPoint {
  std::size_t index = 0;
  double weight = 0.0;
};

/// Residuals [px] and their derivatives by the free parameters. The rows are u of all points, then v, each times the square
/// root of the point's weight.
struct LinearErrors {
  std::span<const Column> columns;
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
  /// Writes the squared error [px^2] of every point. False if a point has none; such parameters are rejected.
  virtual bool squares(std::span<const double> values, std::span<double> result) = 0;
  /// Computes residuals and derivatives of the given points, valid until the next call. False if a point has none.
  virtual bool compute_jacobian(std::span<const double> values, std::span<const WeightedPoint> points,
                                LinearErrors& result) = 0;
};

/// A parameter that the minimisation may change.
struct FreeParameter {
  std::size_t index = 0;  ///< Index in `values`.
  double lower = 0.0;
  double upper = 0.0;
};

/// First values of the sharpness m. With a low one all points count at first, later only the worst; a high one suits a start
/// whose worst points are known.
inline constexpr double kBlunt = 8.0;
inline constexpr double kSharp = 64.0;

/// Changes the free parameters in `values` within their bounds, inside which they must start. `free` has the order of
/// LinearErrors::columns. Returns the number of steps.
int minimise_maximum(PointErrors& errors, std::span<const FreeParameter> free, double first_sharpness,
                     std::span<double> values);

}  // namespace fca::internal
