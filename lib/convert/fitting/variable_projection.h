// SPDX-License-Identifier: BSD-3-Clause
// Variable projection (Golub & Pereyra 1973, with the derivatives of Kaufman 1975). A pixel is (fx m_x + cx, fy m_y + cy). m
// depends only on the shape, which is what this file calls all parameters but fx, fy, cx, cy. For each shape the best fx, fy,
// cx, cy are the solutions of two linear problems, so that a search has to change the shape only. It needs few steps where a
// search over all parameters would follow a narrow valley.
#pragma once

#include "minimise.h"
#include "sample_jacobian.h"

#include <fca/convert/fit_target.h>

#include <array>
#include <optional>
#include <span>

namespace fca::internal {

/// The cost of a fit as a function of the shape alone.
class VariableProjection {
 public:
  /// True if this class can fit the model, and is faster than a search over all parameters. `fixed`: the parameters that the
  /// fit must not change.
  [[nodiscard]] static bool can_fit(const FitTarget& target, const std::array<bool, kMostParameters>& fixed);

  /// `jacobian` contains the samples and must outlive the object. `start` gives the shape() and the first fx, fy, cx, cy.
  VariableProjection(SampleJacobian& jacobian, const ParameterValues& start, const std::array<bool, kMostParameters>& fixed);

  /// Computes the smallest cost for a shape, and gradient and Hessian unless their spans are empty. False if a sample has no
  /// pixel, the samples do not determine focal length and centre, or a focal length would change its sign.
  bool evaluate(const double* shape, NormalEquations& sums);

  /// The shape of `start`.
  [[nodiscard]] std::span<const double> shape() const { return std::span(start_).first(count_); }
  /// Returns all parameters for a shape. If the shape cannot be evaluated, returns those of the last shape that evaluate()
  /// computed with derivatives, or the start.
  [[nodiscard]] ParameterValues values_at(std::span<const double> shape);

 private:
  /// The number of linear parameters: the model's first four, fx fy cx cy.
  static constexpr std::size_t kLinear = 4;
  static constexpr std::size_t kMostShapeParameters = kMostParameters - kLinear;

  /// The equations of one image axis, u or v, for all samples. Their columns are the derivatives with respect to the shape's
  /// parameters, focal length and centre, then the residuals. The class keeps the dot products of all pairs of columns, and the
  /// changes of focal length and centre that minimise the residuals.
  class AxisEquations {
   public:
    /// Computes the dot products and the changes for an axis, 0 (u) or 1 (v), of `jacobian`. False if the samples do not
    /// determine focal length and centre, as when all are at one place.
    bool compute(SampleJacobian& jacobian, std::size_t axis);

    [[nodiscard]] double focal_change() const { return change_[0]; }
    [[nodiscard]] double centre_change() const { return change_[1]; }
    /// The sum of squared residuals [px^2] after the changes.
    [[nodiscard]] double cost() const;
    /// Adds gradient and Gauss-Newton matrix of the cost with respect to the shape's parameters. `scale`: the focal length
    /// after its change, divided by that before.
    void add_to(double scale, const NormalEquations& sums) const;

   private:
    bool solve();
    /// Indices of the columns of focal length, centre and residuals. Those of the shape come first.
    [[nodiscard]] std::size_t focal() const { return shape_count_; }
    [[nodiscard]] std::size_t centre() const { return shape_count_ + 1; }
    [[nodiscard]] std::size_t residual() const { return shape_count_ + 2; }
    /// The dot product of columns i <= j.
    [[nodiscard]] double dot(std::size_t i, std::size_t j) const { return dots_[i * (shape_count_ + kOtherColumns) + j]; }
    /// The solution of the normal equations of focal length and centre for a right side.
    [[nodiscard]] std::array<double, 2> solution(double right_of_focal, double right_of_centre) const;

    static constexpr std::size_t kOtherColumns = 3;  ///< Focal length, centre, residuals.
    std::size_t shape_count_ = 0;
    std::array<double, (kMostShapeParameters + kOtherColumns) * (kMostShapeParameters + kOtherColumns)> dots_;
    std::array<double, 3> inverse_{};  ///< Inverse of the symmetric 2 x 2 matrix of the normal equations: xx, xy, yy.
    std::array<double, 2> change_{};   ///< Of focal length and centre.
  };

  bool compute_equations(const ParameterValues& values);

  SampleJacobian& jacobian_;
  /// The parameters of the last evaluation with derivatives, including the best focal lengths and centre for its shape. Before
  /// the first one: the start.
  ParameterValues values_;
  std::size_t count_ = 0;                               ///< Number of shape parameters.
  std::array<std::size_t, kMostParameters> indices_{};  ///< Indices of the shape parameters among all parameters.
  std::array<double, kMostParameters> start_{};         ///< The start's shape.
  std::array<AxisEquations, 2> axes_;
  std::optional<ParameterValues> at_;  ///< The parameters for which axes_ were computed.
};

}  // namespace fca::internal
