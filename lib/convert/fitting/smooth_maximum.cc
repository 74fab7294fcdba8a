// SPDX-License-Identifier: BSD-3-Clause
#include "smooth_maximum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>

namespace fca::internal {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// The smooth maximum (1/m) log sum exp(m s_k / scale) of the squared errors s_k, where m is the sharpness.
class SmoothMaximum {
 public:
  SmoothMaximum(PointErrors& errors, double sharpness) : errors_(errors), sharpness_(sharpness), squares_(errors.size()) {}

  /// The smooth maximum, in units of scale(). Infinite if a point has no error.
  [[nodiscard]] double at(std::span<const double> values) {
    if (!errors_.squares(values, squares_)) return std::numeric_limits<double>::infinity();
    largest_ = *std::ranges::max_element(squares_);
    if (!(scale_ > 0.0)) scale_ = largest_;
    double sum = 0.0;
    for (const double square : squares_) sum += std::exp(sharpness_ * (square - largest_) / scale_);
    sum_ = sum;
    return largest_ / scale_ + std::log(sum) / sharpness_;
  }

  /// The weights of the points in the gradient of the smooth maximum, at the parameters of the last at(). They sum to 1. Points
  /// with a weight of at most 1e-9 are omitted.
  [[nodiscard]] std::vector<WeightedPoint> weights() const {
    constexpr double kNegligibleWeight = 1e-9;
    std::vector<WeightedPoint> result;
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      const double weight = std::exp(sharpness_ * (squares_[i] - largest_) / scale_) / sum_;
      if (weight > kNegligibleWeight) result.push_back({i, weight});
    }
    return result;
  }

  /// The unit of the smooth maximum [px^2]: the largest squared error in the first call of at().
  [[nodiscard]] double scale() const { return scale_; }

 private:
  PointErrors& errors_;
  double sharpness_;
  std::vector<double> squares_;
  double scale_ = 0.0;    ///< 0 before the first call of at().
  double largest_ = 0.0;  ///< The largest squared error [px^2] at the parameters of the last at().
  double sum_ = 0.0;      ///< The sum of exp(m (s_k - largest_) / scale_).
};

/// The first `rows` numbers of a column as a vector, without a copy.
Eigen::Map<const Vector> mapped(const Column& column, std::size_t rows) {
  return {column.data, static_cast<Eigen::Index>(rows)};
}

/// The triangular matrix R of the QR decomposition of `system`.
Matrix triangle_of(const Matrix& system) {
  const Eigen::Index height = std::min(system.rows(), system.cols());
  return Eigen::HouseholderQR<Matrix>(system).matrixQR().topRows(height).triangularView<Eigen::Upper>();
}

/// The smooth maximum near given parameters, as a least-squares problem |A d - b|^2 / 2 with the same gradient and Hessian H at
/// the step d = 0. H = sum 2 w_k J_k'J_k + m sum w_k (g_k - g)(g_k - g)' with the weights w_k, residuals e_k and Jacobians J_k
/// of the points, g_k = 2 J_k'e_k, and the weighted mean g of g_k. The problem is kept as the triangular matrix of [A b], since
/// A'A would have the squared condition number of A.
struct Quadratic {
  Matrix triangle;  ///< A in triangular form.
  Vector right;     ///< b in the same form.
  Vector gradient;
};

/// Expands the smooth maximum to second order. `linear`: the errors of `points`. `columns`: indices in linear.columns of the
/// parameters that may change. `scale` [px^2]: the unit of the smooth maximum.
Quadratic expand(const LinearErrors& linear, std::span<const WeightedPoint> points, std::span<const std::size_t> columns,
                 double sharpness, double scale) {
  const auto n = static_cast<Eigen::Index>(points.size());
  const auto count = static_cast<Eigen::Index>(columns.size());
  const std::size_t rows = 2 * points.size();
  Matrix system(3 * n, count + 1);  // the last column is the right side
  auto residuals = system.col(count);
  residuals.head(2 * n) = mapped(linear.residuals, rows) / -std::sqrt(scale);
  residuals.tail(n).setZero();
  Vector roots(n);
  for (Eigen::Index k = 0; k < n; ++k) roots[k] = std::sqrt(points[static_cast<std::size_t>(k)].weight);
  Quadratic result;
  result.gradient.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    auto column = system.col(i);
    column.head(2 * n) = mapped(linear.columns[columns[static_cast<std::size_t>(i)]], rows) / std::sqrt(scale);
    // At first w_k g_k, whose sum over k is g; then sqrt(m w_k) (g_k - g).
    auto deviations = column.tail(n);
    deviations =
        -2.0 * (column.head(n).cwiseProduct(residuals.head(n)) + column.segment(n, n).cwiseProduct(residuals.segment(n, n)));
    result.gradient[i] = deviations.sum();
    deviations = std::sqrt(sharpness) * (deviations.cwiseQuotient(roots) - result.gradient[i] * roots);
  }
  system.topRows(2 * n) *= std::sqrt(2.0);
  const Matrix upper = triangle_of(system);
  result.triangle = upper.leftCols(count);
  result.right = upper.col(count);
  return result;
}

/// The damped Newton step. `effects`: how far each parameter moves the points, as an rms over all points. The damping of a
/// parameter is proportional to its effect on all points: a parameter that moves only points of small weight would otherwise
/// become arbitrarily large.
Vector damped_step(const Quadratic& quadratic, const Vector& effects, double damping) {
  const Eigen::Index height = quadratic.triangle.rows();
  const Eigen::Index count = quadratic.triangle.cols();
  Matrix system(height + count, count);
  system.topRows(height) = quadratic.triangle;
  system.bottomRows(count) = Vector(std::sqrt(damping) * effects).asDiagonal();
  Vector right = Vector::Zero(system.rows());
  right.head(height) = quadratic.right;
  return Eigen::HouseholderQR<Matrix>(system).solve(right);
}

/// The decrease of the smooth maximum that the quadratic predicts for a step.
double predicted_decrease(const Quadratic& quadratic, const Vector& step) {
  return 0.5 * (quadratic.right.squaredNorm() - (quadratic.right - quadratic.triangle * step).squaredNorm());
}

/// Minimises the smooth maximum for one sharpness.
class Descent {
 public:
  Descent(PointErrors& errors, std::span<const FreeParameter> free, double sharpness, std::span<double> values)
      : errors_(errors), free_(free), sharpness_(sharpness), values_(values), maximum_(errors, sharpness) {}

  /// Returns the number of steps.
  int run() {
    constexpr int kMostSteps = 100;
    double value = maximum_.at(values_);
    if (!(std::isfinite(value) && maximum_.scale() > 0.0)) return 0;
    if (!compute_effects()) return 0;
    double damping = kFirstDamping;
    for (int step = 0; step < kMostSteps; ++step) {
      if (!expand_here()) return step;
      if (largest_predicted_decrease() < kNegligible / sharpness_ || !improve(damping, value)) return step;
    }
    return kMostSteps;
  }

 private:
  static constexpr double kFirstDamping = 1e-3;
  /// The descent ends if the predicted decrease is below kNegligible / m. The smooth maximum exceeds the maximum by about 1 /
  /// m.
  static constexpr double kNegligible = 1e-3;

  /// Computes effects_. False if a point has no derivative.
  bool compute_effects() {
    std::vector<WeightedPoint> all(errors_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = {i, 1.0 / static_cast<double>(all.size())};
    LinearErrors linear;
    if (!errors_.compute_jacobian(values_, all, linear)) return false;
    effects_.resize(static_cast<Eigen::Index>(free_.size()));
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const double effect = mapped(linear.columns[i], 2 * all.size()).norm() / std::sqrt(maximum_.scale());
      effects_[static_cast<Eigen::Index>(i)] = effect > 0.0 ? effect : 1.0;
    }
    return true;
  }

  /// Expands the smooth maximum at the current parameters. Excludes parameters at a bound that a step downhill would move
  /// outside. False if no parameter remains, or a point has no derivative.
  bool expand_here() {
    const std::vector<WeightedPoint> points = maximum_.weights();
    LinearErrors linear;
    if (!errors_.compute_jacobian(values_, points, linear)) return false;
    columns_.resize(free_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i] = i;
    quadratic_ = expand(linear, points, columns_, sharpness_, maximum_.scale());
    const Vector gradient = quadratic_.gradient;
    const std::size_t held = std::erase_if(columns_, [&](std::size_t i) {
      const double value = values_[free_[i].index];
      const double derivative = gradient[static_cast<Eigen::Index>(i)];
      return (value <= free_[i].lower && derivative > 0.0) || (value >= free_[i].upper && derivative < 0.0);
    });
    if (held > 0) quadratic_ = expand(linear, points, columns_, sharpness_, maximum_.scale());
    return !columns_.empty();
  }

  /// The decrease that the quadratic predicts for a step without damping.
  [[nodiscard]] double largest_predicted_decrease() const { return 0.5 * quadratic_.right.head(count()).squaredNorm(); }
  /// The number of elements of quadratic_.right that a step can make 0.
  [[nodiscard]] Eigen::Index count() const {
    return std::min(quadratic_.right.size(), static_cast<Eigen::Index>(columns_.size()));
  }

  /// Takes one step that reduces the smooth maximum `value`. Increases the damping until a step does. False, with unchanged
  /// parameters, if none does.
  bool improve(double& damping, double& value) {
    constexpr double kMostDamping = 1e12;
    constexpr double kDampingDecrease = 0.1;
    constexpr double kDampingIncrease = 8.0;
    constexpr double kGoodDecreaseRatio = 0.5;  // of the actual decrease to the predicted one
    Vector effects(static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k)
      effects[static_cast<Eigen::Index>(k)] = effects_[static_cast<Eigen::Index>(columns_[k])];
    const std::vector<double> before(values_.begin(), values_.end());
    for (; damping < kMostDamping; damping *= kDampingIncrease) {
      const Vector step = damped_step(quadratic_, effects, damping);
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        const FreeParameter& p = free_[columns_[k]];
        values_[p.index] = std::clamp(before[p.index] + step[static_cast<Eigen::Index>(k)], p.lower, p.upper);
      }
      const double next = maximum_.at(values_);
      if (!(next < value)) continue;
      if (value - next > kGoodDecreaseRatio * predicted_decrease(quadratic_, step)) damping *= kDampingDecrease;
      value = next;
      return true;
    }
    std::ranges::copy(before, values_.begin());
    return false;
  }

  PointErrors& errors_;
  std::span<const FreeParameter> free_;
  double sharpness_;
  std::span<double> values_;
  SmoothMaximum maximum_;
  std::vector<std::size_t> columns_;  ///< Indices in free_ of the parameters that the next step may change.
  Quadratic quadratic_;
  /// How far each free parameter moves the points: the rms over all points, in units of the root of the scale.
  Vector effects_;
};

}  // namespace

int minimise_maximum(PointErrors& errors, std::span<const FreeParameter> free, double first_sharpness,
                     std::span<double> values) {
  constexpr double kLastSharpness = 32768.0;
  constexpr double kSharpnessFactor = 4.0;
  int steps = 0;
  for (double sharpness = first_sharpness; sharpness <= kLastSharpness; sharpness *= kSharpnessFactor)
    steps += Descent(errors, free, sharpness, values).run();
  return steps;
}

}  // namespace fca::internal
