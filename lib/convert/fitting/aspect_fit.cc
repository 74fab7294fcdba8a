// SPDX-License-Identifier: BSD-3-Clause
#include "aspect_fit.h"

#include "normal_equations.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace fca::internal {

namespace {

// The unknowns: the terms' coefficients, cx, cy, aspect.
constexpr int kMostUnknowns = static_cast<int>(kMostTerms) + 3;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMostUnknowns, kMostUnknowns>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostUnknowns, 1>;

/// Solves A x = b by Cholesky's method, after scaling the unknowns so that A's diagonal is 1. nullopt if A is not positive
/// definite.
std::optional<Vector> solve_definite(const Matrix& A, const Vector& b) {
  const Vector diagonal = A.diagonal();
  if (!(diagonal.minCoeff() > 0.0)) return std::nullopt;
  const Vector unit = diagonal.cwiseSqrt().cwiseInverse();
  const Matrix scaled = unit.asDiagonal() * A * unit.asDiagonal();
  const Eigen::LLT<Matrix> factors(scaled);
  if (factors.info() != Eigen::Success) return std::nullopt;
  const Vector weighted = unit.cwiseProduct(b);
  const Vector solution = factors.solve(weighted);
  if (!solution.allFinite()) return std::nullopt;
  return Vector(unit.cwiseProduct(solution));
}

/// The dot products of all pairs of columns of one image axis: the model's terms, then the column of cx or cy, which are all
/// times the square roots of the points' weights.
Matrix moments(std::span<const Column> columns) {
  const auto n = static_cast<Eigen::Index>(columns.size());
  Matrix result(n, n);
  dot_products(columns, result.data());
  result.triangularView<Eigen::StrictlyLower>() = result.transpose();
  return result;
}

}  // namespace

void AspectFit::set(std::size_t point, const double* terms_u, const double* terms_v, const std::array<double, 2>& pixel,
                    double weight) {
  const double root = std::sqrt(weight);
  for (std::size_t i = 0; i < terms_; ++i) {
    term_u(i)[point] = root * terms_u[i];
    term_v(i)[point] = root * terms_v[i];
  }
  roots()[point] = root;
  for (const std::size_t axis : {0U, 1U}) pixels(axis)[point] = root * pixel[axis];
}

std::optional<AspectFit::Solution> AspectFit::solve(double aspect) {
  const auto n = static_cast<Eigen::Index>(terms_);
  std::array<Column, kMostTerms + 1> columns_u;
  std::array<Column, kMostTerms + 1> columns_v;
  for (std::size_t i = 0; i < terms_; ++i) {
    columns_u[i] = {term_u(i), 0, points_};
    columns_v[i] = {term_v(i), 0, points_};
  }
  columns_u[terms_] = columns_v[terms_] = {roots(), 0, points_};
  const std::span<const Column> of_u = std::span(columns_u).first(terms_ + 1);
  const std::span<const Column> of_v = std::span(columns_v).first(terms_ + 1);
  const Matrix moments_u = moments(of_u);
  const Matrix moments_v = moments(of_v);

  // The matrix J^T J of the Gauss-Newton step at the unknowns x. It is computed from the dot products, which are the same in
  // every round. The residuals are computed point by point in every round: rounding errors of the dot products then cost
  // additional rounds but no accuracy.
  const auto hessian_at = [&](const Vector& x) {
    const double a = x[n + 2];
    Matrix H = Matrix::Zero(n + 3, n + 3);
    H.topLeftCorner(n, n) = moments_u.topLeftCorner(n, n) + a * a * moments_v.topLeftCorner(n, n);
    H.block(0, n, n, 1) = moments_u.block(0, n, n, 1);
    H.block(0, n + 1, n, 1) = a * moments_v.block(0, n, n, 1);
    H(n, n) = moments_u(n, n);
    H(n + 1, n + 1) = moments_v(n, n);
    const Vector q = moments_v.topLeftCorner(n, n) * x.head(n);
    H.block(0, n + 2, n, 1) = a * q;
    H(n + 1, n + 2) = moments_v.col(n).head(n).dot(x.head(n));
    H(n + 2, n + 2) = x.head(n).dot(q);
    H.triangularView<Eigen::StrictlyLower>() = H.transpose();
    return H;
  };

  Vector x = Vector::Zero(n + 3);
  x[n + 2] = aspect;
  std::vector<double> residuals(2 * points_);
  double* const ru = residuals.data();
  double* const rv = ru + points_;
  double previous = 0.0;
  constexpr int kMostRounds = 12;
  for (int round = 0; round < kMostRounds; ++round) {
    const double a = x[n + 2];
    for (std::size_t k = 0; k < points_; ++k) {
      ru[k] = x[n] * roots()[k] - pixels(0)[k];
      rv[k] = x[n + 1] * roots()[k] - pixels(1)[k];
    }
    if (round > 0) {
      for (Eigen::Index i = 0; i < n; ++i) {
        const double cu = x[i];
        const double cv = a * x[i];
        const double* const tu = term_u(static_cast<std::size_t>(i));
        const double* const tv = term_v(static_cast<std::size_t>(i));
        for (std::size_t k = 0; k < points_; ++k) {
          ru[k] += cu * tu[k];
          rv[k] += cv * tv[k];
        }
      }
    }
    const Column r_u{ru, 0, points_};
    const Column r_v{rv, 0, points_};
    double cost_u = 0.0;
    double cost_v = 0.0;
    dot_products(std::span(&r_u, 1), r_u, &cost_u);
    dot_products(std::span(&r_v, 1), r_v, &cost_v);
    const double cost = cost_u + cost_v;
    // The iteration diverges if the cost grows by more than rounding errors.
    constexpr double kExactCost = 1e-20;  // px^2
    constexpr double kRounding = 1e-9;
    if (!std::isfinite(cost) || (round > 1 && cost > previous * (1.0 + kRounding) + kExactCost)) return std::nullopt;
    previous = cost;

    Vector sums_u(n + 1);
    Vector sums_v(n + 1);
    dot_products(of_u, r_u, sums_u.data());
    dot_products(of_v, r_v, sums_v.data());
    Vector gradient(n + 3);
    gradient.head(n) = sums_u.head(n) + a * sums_v.head(n);
    gradient[n] = sums_u[n];
    gradient[n + 1] = sums_v[n];
    gradient[n + 2] = sums_v.head(n).dot(x.head(n));
    // In round 0 all coefficients are 0. No pixel then depends on the aspect ratio, which becomes an unknown in round 1.
    const Matrix H = hessian_at(x);
    const Eigen::Index unknowns = round == 0 ? n + 2 : n + 3;
    const std::optional<Vector> step = solve_definite(H.topLeftCorner(unknowns, unknowns), gradient.head(unknowns));
    if (!step) return std::nullopt;
    x.head(unknowns) -= *step;
    if (round == 0) continue;
    const double gain = gradient.dot(*step);
    constexpr double kNegligibleGain = 1e-12;  // fraction of the cost
    constexpr double kNegligibleCost = 1e-26;  // px^2
    if (gain > kNegligibleGain * cost && gain > kNegligibleCost) continue;
    Solution solution;
    for (Eigen::Index i = 0; i < n; ++i) solution.coefficients[static_cast<std::size_t>(i)] = x[i];
    solution.aspect = x[n + 2];
    solution.point = {x[n], x[n + 1]};
    solution.cost = std::max(0.0, cost - gain);
    solution.iterations = round + 1;
    return solution;
  }
  return std::nullopt;
}

}  // namespace fca::internal
