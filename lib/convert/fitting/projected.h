// SPDX-License-Identifier: BSD-3-Clause
// Variable projection (Golub & Pereyra 1973, with the derivatives of Kaufman 1975). A pixel is (fx m_x + cx, fy m_y + cy),
// where m depends on the shape, all other parameters, alone. For each shape the best fx, fy, cx, cy follow from two linear
// solutions, so that only the shape is searched for. That takes few steps where a search in all parameters follows a narrow
// valley.
#pragma once

#include "minimise.h"
#include "sample_jacobian.h"

#include <fca/convert/fit_target.h>

#include <array>
#include <optional>
#include <span>

namespace fca::internal {

class Projected {
 public:
  /// True if a model can be fitted in this way, with these parameters fixed.
  [[nodiscard]] static bool suits(const FitTarget& target, const std::array<bool, kMostParameters>& fixed);

  /// `jacobian` holds the samples and must outlive the object. The shape and the first fx, fy, cx, cy are those of `start`.
  Projected(SampleJacobian& jacobian, const ParameterValues& start, const std::array<bool, kMostParameters>& fixed);

  /// Computes the cost for a shape, and gradient and Hessian unless their spans are empty. False if a sample has no pixel.
  bool evaluate(const double* shape, NormalEquations& sums);

  /// The shape of `start`.
  [[nodiscard]] std::span<const double> shape() const { return std::span(start_).first(count_); }
  /// All parameters for a shape; if it cannot be evaluated, those of the last shape that was.
  [[nodiscard]] ParameterValues values_at(std::span<const double> shape);

 private:
  /// The number of linear parameters: the model's first four, fx fy cx cy.
  static constexpr std::size_t kLinear = 4;
  static constexpr std::size_t kMostShape = kMostParameters - kLinear;

  /// The equations of one image axis, u or v, for all samples. The Jacobian's columns are those of the shape's parameters, then
  /// focal length and centre, then the residuals. Keeps the dot products of all pairs of columns, and the changes of focal
  /// length and centre that minimise the residuals.
  class Coordinate {
   public:
    /// Computes the dot products. False if the samples do not determine focal length and centre (all at one place).
    bool look_at(SampleJacobian& jacobian, std::size_t axis);

    [[nodiscard]] double focal_change() const { return change_[0]; }
    [[nodiscard]] double centre_change() const { return change_[1]; }
    [[nodiscard]] double cost() const;
    void add_to(double scale, const NormalEquations& sums) const;

   private:
    bool solve();
    [[nodiscard]] std::size_t focal() const { return shape_; }
    [[nodiscard]] std::size_t centre() const { return shape_ + 1; }
    [[nodiscard]] std::size_t residual() const { return shape_ + 2; }
    /// The dot product of columns i <= j.
    [[nodiscard]] double sum(std::size_t i, std::size_t j) const { return sums_[i * (shape_ + kOthers) + j]; }
    /// The solution of the two normal equations for that right side.
    [[nodiscard]] std::array<double, 2> solution(double of_focal, double of_centre) const;

    static constexpr std::size_t kOthers = 3;
    std::size_t shape_ = 0;  ///< Number of shape columns.
    std::array<double, (kMostShape + kOthers) * (kMostShape + kOthers)> sums_;
    std::array<double, 3> inverse_{};  ///< Inverse of the symmetric 2 x 2 matrix of the normal equations.
    std::array<double, 2> change_{};
  };

  bool look_at(const ParameterValues& values);

  SampleJacobian& jacobian_;
  /// The parameters of the last evaluation with derivatives, with the best focal lengths and centre there.
  ParameterValues values_;
  std::size_t count_ = 0;                               ///< Number of shape parameters.
  std::array<std::size_t, kMostParameters> indices_{};  ///< Indices of the shape parameters among all parameters.
  std::array<double, kMostParameters> start_{};
  std::array<Coordinate, 2> coordinates_;
  std::optional<ParameterValues> at_;  ///< The parameters for which coordinates_ were computed.
};

}  // namespace fca::internal
