// SPDX-License-Identifier: BSD-3-Clause
// Variable projection (Golub & Pereyra 1973, with the derivatives of Kaufman 1975): a pixel is (fx m_x + cx, fy m_y + cy), so
// for each shape of a lens the best fx, fy, cx, cy are two linear solutions, and only the shape must be searched for. What is a
// narrow valley in all parameters is a short way in those.
#pragma once

#include "linearised.h"
#include "minimise.h"

#include <fca/convert/fit_target.h>

#include <array>
#include <optional>
#include <span>

namespace fca::internal {

class Projected {
 public:
  /// Can a model be fitted in this way, with these parameters fixed?
  [[nodiscard]] static bool suits(const FitTarget& target, const std::array<bool, kMostParameters>& fixed);

  /// `linearised` holds the samples and must outlive it; begins at `start`.
  Projected(Linearised& linearised, const ParameterValues& start, const std::array<bool, kMostParameters>& fixed);

  /// What a step of the solver needs at a shape; false where a sample has no pixel.
  bool evaluate(const double* shape, NormalEquations& sums);

  /// The shape to begin with.
  [[nodiscard]] std::span<const double> shape() const { return std::span(start_).first(count_); }
  /// All parameters for a shape; where that cannot be evaluated, those of the shape evaluated last.
  [[nodiscard]] ParameterValues values_at(std::span<const double> shape);

 private:
  /// fx fy cx cy, in this order, with which such a model begins.
  static constexpr std::size_t kLinear = 4;
  static constexpr std::size_t kMostShape = kMostParameters - kLinear;

  /// One image axis, u or v, of all samples. Its Jacobian's columns are those of the shape's parameters, then the focal
  /// length's and the centre's; the residuals follow as a last column. It keeps the dot products of all pairs of columns, and
  /// the changes of focal length and centre that make the residuals smallest.
  class Coordinate {
   public:
    /// False if the samples do not determine focal length and centre (all at one place).
    bool look_at(Linearised& linearised, std::size_t axis);

    [[nodiscard]] double focal_change() const { return change_[0]; }
    [[nodiscard]] double centre_change() const { return change_[1]; }
    [[nodiscard]] double cost() const;
    void add_to(double scale, const NormalEquations& sums) const;

   private:
    bool solve();
    [[nodiscard]] std::size_t focal() const { return shape_; }
    [[nodiscard]] std::size_t centre() const { return shape_ + 1; }
    [[nodiscard]] std::size_t residual() const { return shape_ + 2; }
    /// For i <= j.
    [[nodiscard]] double sum(std::size_t i, std::size_t j) const { return sums_[i * (shape_ + kOthers) + j]; }
    /// Of the two normal equations with that right side.
    [[nodiscard]] std::array<double, 2> solution(double of_focal, double of_centre) const;

    static constexpr std::size_t kOthers = 3;
    std::size_t shape_ = 0;  ///< How many columns are of the shape.
    std::array<double, (kMostShape + kOthers) * (kMostShape + kOthers)> sums_;
    std::array<double, 3> inverse_{};  ///< Of the symmetric 2 x 2 matrix of the normal equations.
    std::array<double, 2> change_{};
  };

  bool look_at(const ParameterValues& values);

  Linearised& linearised_;
  /// Of the last evaluation with slopes, with the focal lengths and the centre that are best there.
  ParameterValues values_;
  std::size_t count_ = 0;                               ///< Of the shape's parameters.
  std::array<std::size_t, kMostParameters> indices_{};  ///< Theirs among all.
  std::array<double, kMostParameters> start_{};
  std::array<Coordinate, 2> coordinates_;
  std::optional<ParameterValues> at_;  ///< The parameters for which coordinates_ were computed.
};

}  // namespace fca::internal
