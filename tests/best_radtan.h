// SPDX-License-Identifier: BSD-3-Clause
// The least error that a radtan can have over a cone without folding there, found by another way than the library's: by a
// barrier, from 20 random starts, over every pixel. Shares no code with the library's fits.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/models/camera_model.h>
#include <fca/rig/rig.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace fca::test {

/// What of a camera's image lies inside an angle.
class Cone {
 public:
  Cone(const Camera& camera, double angle_rad) : largest_tangent_(std::tan(angle_rad)), centre_(principal_point(camera.model)) {
    Diagnostics diagnostics;
    const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, angle_rad, diagnostics);
    if (!field_of_view) return;
    const Lens lens(camera.model);
    for (int v = 0; v < field_of_view->size.height; ++v) {
      for (int u = 0; u < field_of_view->size.width; ++u) add(*field_of_view, lens, {1.0 * u, 1.0 * v});
    }
    for (Moments& axis : moments_) axis /= static_cast<double>(points_.size());
  }

  /// Sums over the pixels, divided by their number, of the products of x, x r^2, x r^4, 2 x y, r^2 + 2 x^2, x r^6, 1 and
  /// -(u - u of the principal point); and the same of v.
  using Moments = Eigen::Matrix<double, 8, 8>;
  [[nodiscard]] const std::array<Moments, 2>& moments() const { return moments_; }
  [[nodiscard]] const Pixel& centre() const { return centre_; }
  [[nodiscard]] double largest_tangent() const { return largest_tangent_; }  ///< tan of the angle.

  /// Of a model in px; infinite where a pixel's ray has none in it.
  [[nodiscard]] double rms_of(const CameraModel& model) const {
    double sum = 0.0;
    for (const auto& [ray, pixel] : points_) {
      const std::optional<Pixel> found = project(model, ray);
      if (!found) return HUGE_VAL;
      sum += std::pow((*found)[0] - pixel[0], 2) + std::pow((*found)[1] - pixel[1], 2);
    }
    return std::sqrt(sum / static_cast<double>(points_.size()));
  }

 private:
  struct Point {
    Ray ray;
    Pixel pixel;
  };

  void add(const FieldOfView& field_of_view, const Lens& lens, const Pixel& pixel) {
    const std::optional<Ray> ray = field_of_view.ray(lens, pixel);
    if (!ray) return;
    points_.push_back({*ray, pixel});
    const double x = (*ray)[0] / (*ray)[2];
    const double y = (*ray)[1] / (*ray)[2];
    const double s = x * x + y * y;
    using Row = Eigen::Matrix<double, 8, 1>;
    const Row of_u{x, x * s, x * s * s, 2.0 * x * y, s + 2.0 * x * x, x * s * s * s, 1.0, centre_[0] - pixel[0]};
    const Row of_v{y, y * s, y * s * s, s + 2.0 * y * y, 2.0 * x * y, y * s * s * s, 1.0, centre_[1] - pixel[1]};
    moments_[0] += of_u * of_u.transpose();
    moments_[1] += of_v * of_v.transpose();
  }

  double largest_tangent_;
  Pixel centre_;
  std::vector<Point> points_;
  std::array<Moments, 2> moments_ = {Moments::Zero(), Moments::Zero()};
};

/// radtan over a cone, as fx fy cx cy k1 k2 p1 p2 [k3], the centre counted from the cone's.
class BarrierFit {
 public:
  using Vector = Eigen::Matrix<double, 9, 1>;
  using Matrix = Eigen::Matrix<double, 9, 9>;

  /// `coefficients`: 4 (k3 stays 0) or 5.
  BarrierFit(const Cone& cone, int coefficients) : cone_(cone), count_(4 + coefficients) {}

  /// The mean squared distance in px^2 to which a start leads; infinite where the start folds.
  [[nodiscard]] double best_from(Vector p) const {
    constexpr double kFirst = 1e-4;  // a stronger barrier drives coefficients to infinity
    constexpr double kFalls = 0.1;
    constexpr double kLast = 1e-9;  // of the cost: 600 conditions then cost less than a millionth of it
    constexpr int kSteps = 100;
    if (!std::isfinite(barrier(p))) return HUGE_VAL;
    double best = cost(p);
    for (double weight = kFirst * best; weight > kLast * best; best = cost(p)) {
      weight *= kFalls;
      for (int step = 0; step < kSteps && descend(weight, p); ++step) {
      }
    }
    return best;
  }

  /// A random camera that does not fold.
  template <class Generator>
  [[nodiscard]] Vector random_start(const std::array<double, 2>& focal, Generator& generator) const {
    const auto between = [&generator](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(generator);
    };
    Vector p;
    p << focal[0] * between(0.7, 1.3), focal[1] * between(0.7, 1.3), between(-20.0, 20.0), between(-20.0, 20.0),
        between(-0.4, 0.4), between(-0.1, 0.1), between(-0.01, 0.01), between(-0.01, 0.01), between(-0.02, 0.02);
    if (count_ < 9) p[8] = 0.0;
    while (!std::isfinite(barrier(p))) p.tail(5) *= 0.5;
    return p;
  }

 private:
  static constexpr int kPlaces = 300;  ///< Where a camera is asked whether it folds.

  /// Mean squared distance. Adds half of its gradient and of its Gauss-Newton matrix where those are given.
  double cost(const Vector& p, Vector* gradient = nullptr, Matrix* matrix = nullptr) const {
    double sum = 0.0;
    for (const int axis : {0, 1}) {
      const double f = p[axis];
      Eigen::Matrix<double, 8, 1> a;
      a << f, f * p[4], f * p[5], f * p[6], f * p[7], f * p[8], p[2 + axis], 1.0;
      const Eigen::Matrix<double, 8, 1> product = cone_.moments()[static_cast<std::size_t>(axis)] * a;
      sum += a.dot(product);
      if (gradient == nullptr) continue;
      Eigen::Matrix<double, 8, 9> derivatives = Eigen::Matrix<double, 8, 9>::Zero();
      derivatives.col(axis) << 1.0, p[4], p[5], p[6], p[7], p[8], 0.0, 0.0;
      for (const int i : {4, 5, 6, 7, 8}) derivatives(i - 3, i) = f;
      derivatives(6, 2 + axis) = 1.0;
      *gradient += derivatives.transpose() * product;
      *matrix += derivatives.transpose() * cone_.moments()[static_cast<std::size_t>(axis)] * derivatives;
    }
    return sum;
  }

  /// The sum of -log of what must be positive at each radius, whatever the azimuth, so that nothing folds; infinite where
  /// something does. Adds half of its derivatives, times `weight`, where those are given.
  double barrier(const Vector& p, double weight = 0.0, Vector* gradient = nullptr, Matrix* matrix = nullptr) const {
    constexpr double kRounded = 1e-7;  // the peak of the cone |(p1, p2)|
    const double length = std::sqrt(p[6] * p[6] + p[7] * p[7] + kRounded * kRounded);
    double sum = 0.0;
    for (int place = 1; place <= kPlaces; ++place) {
      const double r = cone_.largest_tangent() * place / kPlaces;
      const double s = r * r;
      for (const std::array<double, 4>& c : {std::array{3.0, 5.0, 7.0, 6.0}, std::array{1.5, 2.0, 2.5, 4.0}}) {
        const double value = 1.0 + c[0] * p[4] * s + c[1] * p[5] * s * s + c[2] * p[8] * s * s * s - c[3] * length * r;
        if (!(value > 0.0)) return HUGE_VAL;
        sum -= std::log(value);
        if (gradient == nullptr) continue;
        Vector derivative = Vector::Zero();
        derivative[4] = c[0] * s;
        derivative[5] = c[1] * s * s;
        derivative[8] = c[2] * s * s * s;
        const Eigen::Vector2d direction = p.segment<2>(6) / length;
        derivative.segment<2>(6) = -c[3] * r * direction;
        *gradient -= 0.5 * weight / value * derivative;
        *matrix += 0.5 * weight / (value * value) * derivative * derivative.transpose();
        matrix->block<2, 2>(6, 6) +=
            0.5 * weight / value * c[3] * r / length * (Eigen::Matrix2d::Identity() - direction * direction.transpose());
      }
    }
    return sum;
  }

  /// A Newton step, halved until it leads down; false at the minimum.
  bool descend(double weight, Vector& p) const {
    constexpr double kNothing = 1e-9;
    constexpr double kShortest = 1e-8;
    Vector gradient = Vector::Zero();
    Matrix matrix = Matrix::Zero();
    const double here = cost(p, &gradient, &matrix) + weight * barrier(p, weight, &gradient, &matrix);
    const Eigen::VectorXd g = gradient.head(count_);
    const Eigen::MatrixXd H = matrix.topLeftCorner(count_, count_);
    const Eigen::VectorXd unit = H.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = unit.asDiagonal() * H * unit.asDiagonal();
    Vector step = Vector::Zero();
    step.head(count_) = unit.cwiseProduct(scaled.ldlt().solve(unit.cwiseProduct(g)));
    for (double share = 1.0; share > kShortest; share *= 0.5) {
      const Vector next = p - share * step;
      const double there = cost(next) + weight * barrier(next);
      if (!(there < here)) continue;
      p = next;
      return here - there > kNothing * std::abs(here);
    }
    return false;
  }

  const Cone& cone_;
  int count_;
};

/// The rms in px of the best of 20 starts.
template <class Generator>
double best_radtan_rms(const Camera& camera, const Cone& cone, int coefficients, Generator& generator) {
  constexpr int kStarts = 20;
  const BarrierFit fit(cone, coefficients);
  double best = HUGE_VAL;
  for (int i = 0; i < kStarts; ++i)
    best = std::min(best, fit.best_from(fit.random_start(central_focal_lengths(camera.model), generator)));
  return std::sqrt(best);
}

}  // namespace fca::test
