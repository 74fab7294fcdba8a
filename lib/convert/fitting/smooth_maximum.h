// SPDX-License-Identifier: BSD-3-Clause
// Minimises the largest error of a set of points over a handful of parameters within bounds.
//
// The largest of the squared errors s_k is replaced by the smooth function (1/m) log sum exp(m s_k) (Kreisselmeier and
// Steinhauser 1979), which exceeds it by at most log(points) / m, and that is minimised by a damped Newton method for rising
// sharpness m (Xu, "Smoothing method for minimax problems", 2001). Of the second derivatives those of the residuals are left
// out, as Gauss and Newton do.
#pragma once

#include "products.h"

#include <cstddef>
#include <span>

namespace fca::internal {

struct WeightedPoint {
  std::size_t index = 0;
  double weight = 0.0;
};

/// Residuals and their derivatives by the free parameters; first the rows of u of all points, then those of v, each times the
/// root of the point's weight.
struct LinearErrors {
  std::span<const Column> columns;
  Column residuals;
};

/// What the minimisation asks of the points.
class PointErrors {
 public:
  PointErrors() = default;
  virtual ~PointErrors() = default;
  PointErrors(const PointErrors&) = delete;
  PointErrors& operator=(const PointErrors&) = delete;

  [[nodiscard]] virtual std::size_t size() const = 0;
  /// The squared error of every point; false where one has none: such parameters are rejected.
  virtual bool squares(std::span<const double> values, std::span<double> result) = 0;
  /// Of some points; nothing where one has none. Valid until the next call.
  virtual bool linearise(std::span<const double> values, std::span<const WeightedPoint> points, LinearErrors& result) = 0;
};

/// A parameter that the minimisation may change.
struct FreeParameter {
  std::size_t index = 0;  ///< Among the values.
  double lower = 0.0;
  double upper = 0.0;
};

/// How sharp the smooth maximum is to begin with: at first all points should have a say, later only the worst.
inline constexpr double kBlunt = 8.0;
inline constexpr double kSharp = 64.0;

/// Changes the free ones of `values` in place, within their bounds, in which they must lie; `free` is in the order of
/// LinearErrors::columns. Returns the number of steps.
int minimise_maximum(PointErrors& errors, std::span<const FreeParameter> free, double first_sharpness,
                     std::span<double> values);

}  // namespace fca::internal
