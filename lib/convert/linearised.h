// SPDX-License-Identifier: BSD-3-Clause
// A model's residuals over samples and their derivatives by the parameters that a fit may change, column by column.
#pragma once

#include "minimise.h"
#include "products.h"

#include <fca/models/model_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <ceres/jet.h>

namespace fca::internal {

/// A model with derivatives of its own (model_traits.h).
template <class M>
concept HasSlopes = requires(const double* in, double* out) {
  { M::formula_and_slopes(in, in, out, out, out) } -> std::same_as<bool>;
};

template <CameraModelType M>
class Linearised {
 public:
  static constexpr std::size_t kCount = kParameterCount<M>;
  using Values = std::array<double, kCount>;

  /// Begins anew, with columns for the parameters that are not fixed. Keeps the samples.
  void reset(std::vector<Correspondence> samples, const std::array<bool, kCount>& fixed) {
    samples_ = std::move(samples);
    const std::size_t points = samples_.size();
    roots_.resize(points);
    std::ranges::transform(samples_, roots_.begin(), [](const Correspondence& s) { return std::sqrt(s.weight); });
    numbers_.resize((kCount + 1) * 2 * points);
    columns_.clear();
    for (std::size_t i = 0; i < kCount; ++i) {
      if (fixed[i]) continue;
      Column column{column_of(i), 0, 2 * points};
      if (kFocalLengthsFirst && i < 4) (i % 2 == 0 ? column.end : column.begin) = points;
      columns_.push_back(column);
    }
    at_.reset();
  }

  /// Residuals: first all of u, then all of v.
  [[nodiscard]] std::size_t rows() const { return 2 * samples_.size(); }
  [[nodiscard]] Column residuals() { return {column_of(kCount), 0, rows()}; }
  /// The Jacobian's columns of the parameters that are not fixed, as linearise() left them.
  [[nodiscard]] std::span<const Column> columns() const { return columns_; }

  /// What a step of the solver needs there; false where a sample has no pixel.
  bool evaluate(const Values& values, NormalEquations& sums) {
    const bool with_slopes = !sums.gradient.empty();
    // With derivatives by hand the cost alone is hardly cheaper, and the solver asks for the slopes where it has just asked for
    // the cost.
    if (!(with_slopes || HasSlopes<M> ? linearise(values) : compute_residuals(values))) return false;
    const Column r = residuals();
    products(std::span(&r, 1), r, &sums.cost);
    if (with_slopes) {
      products(columns_, r, sums.gradient.data());
      products(columns_, sums.hessian.data());
    }
    return true;
  }

  /// The residuals in pixels, times the root of the sample's weight, and their derivatives by all parameters. False where a
  /// sample has no pixel.
  bool linearise(const Values& values) {
    if (at_ == values) return true;
    at_.reset();
    const std::size_t points = samples_.size();
    double* const r = column_of(kCount);
    double* const jacobian = column_of(0);
    std::array<Jet, kCount> parameters;
    if constexpr (!HasSlopes<M>) {
      for (std::size_t i = 0; i < kCount; ++i) parameters[i] = Jet(values[i], static_cast<int>(i));
    }
    for (std::size_t k = 0; k < points; ++k) {
      const Correspondence& s = samples_[k];
      double pixel[2];
      double du[kCount];
      double dv[kCount];
      if constexpr (HasSlopes<M>) {
        if (!M::formula_and_slopes(values.data(), s.ray.data(), pixel, du, dv)) return false;
      } else {
        const Jet ray[3] = {Jet(s.ray[0]), Jet(s.ray[1]), Jet(s.ray[2])};
        Jet jets[2];
        if (!M::formula(parameters.data(), ray, jets)) return false;
        for (std::size_t axis = 0; axis < 2; ++axis) {
          pixel[axis] = jets[axis].a;
          // At an edge of the formula's domain a derivative may be no number.
          for (std::size_t i = 0; i < kCount; ++i) {
            const double slope = jets[axis].v[static_cast<int>(i)];
            (axis == 0 ? du : dv)[i] = std::isfinite(slope) ? slope : 0.0;
          }
        }
      }
      const double root = roots_[k];
      r[k] = root * (pixel[0] - s.pixel[0]);
      r[points + k] = root * (pixel[1] - s.pixel[1]);
      for (std::size_t i = 0; i < kCount; ++i) {
        jacobian[2 * points * i + k] = root * du[i];
        jacobian[2 * points * i + points + k] = root * dv[i];
      }
    }
    at_ = values;
    return true;
  }

 private:
  using Jet = ceres::Jet<double, static_cast<int>(kCount)>;
  /// u depends on fx and cx, v on fy and cy: half of their columns is 0.
  static constexpr bool kFocalLengthsFirst = std::is_base_of_v<FocalLengthsFirst, M>;

  double* column_of(std::size_t parameter) { return numbers_.data() + parameter * rows(); }

  bool compute_residuals(const Values& values) {
    at_.reset();
    const std::size_t points = samples_.size();
    double* const r = column_of(kCount);
    for (std::size_t k = 0; k < points; ++k) {
      const Correspondence& s = samples_[k];
      double pixel[2];
      if (!M::formula(values.data(), s.ray.data(), pixel)) return false;
      r[k] = roots_[k] * (pixel[0] - s.pixel[0]);
      r[points + k] = roots_[k] * (pixel[1] - s.pixel[1]);
    }
    return true;
  }

  std::vector<Correspondence> samples_;
  std::vector<double> roots_;    ///< Of the samples' weights.
  std::vector<double> numbers_;  ///< The Jacobian's columns in the order of the parameters, then the residuals.
  std::vector<Column> columns_;
  std::optional<Values> at_;  ///< Where the columns are those of.
};

}  // namespace fca::internal
