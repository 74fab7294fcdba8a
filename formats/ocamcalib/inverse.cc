// SPDX-License-Identifier: BSD-3-Clause
#include "inverse.h"

#include <fca/models/polynomial_fit.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::ocamcalib {

namespace {

/// The lens as a curve: radius over angle, both from the axis. In the toolbox's own plane, before the affine part.
class Lens {
 public:
  explicit Lens(const Camera& camera) : camera_(camera.model) {
    const auto value = [&camera](ParameterId id) { return parameter(camera.model, id).value(); };
    const double c = value("c");
    const double d = value("d");
    const double e = value("e");
    // The largest factor by which [c d; e 1] stretches: the square root of the larger eigenvalue of its square.
    const double trace = c * c + d * d + e * e + 1.0;
    const double determinant = c - d * e;
    stretch_ = std::sqrt(0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - 4.0 * determinant * determinant))));

    double farthest = 0.0;
    const ImageSize size = camera.image_size.value_or(ImageSize{1, 1});
    for (const double u : {0.0, size.width - 1.0}) {
      for (const double v : {0.0, size.height - 1.0}) {
        const double du = u - value("cx");
        const double dv = v - value("cy");
        farthest = std::max(farthest, std::hypot((dv - d * du) / determinant, (c * du - e * dv) / determinant));
      }
    }
    // The same lens around (0, 0), without the affine part: u is then the radius.
    for (const ParameterId id : ParameterIds{"cx", "cy", "d", "e"}) set_parameter(camera_, id, 0.0);
    set_parameter(camera_, "c", 1.0);
    constexpr double kSmallest = 1.0;  // px: of an image of one pixel, too, there is a curve
    farthest = std::max(farthest, kSmallest);
    const std::optional<Ray> edge = unproject(camera_, {farthest, 0.0});
    largest_angle_ = edge ? std::atan2((*edge)[0], (*edge)[2]) : max_angle(camera_);
  }

  [[nodiscard]] double largest_angle() const { return largest_angle_; }
  [[nodiscard]] double stretch() const { return stretch_; }
  [[nodiscard]] std::optional<double> radius(double angle) const {
    if (angle <= 0.0) return 0.0;
    const std::optional<Pixel> pixel = project(camera_, {std::sin(angle), 0.0, std::cos(angle)});
    if (!pixel) return std::nullopt;
    return (*pixel)[0];
  }

 private:
  CameraModel camera_;
  double largest_angle_ = 0.0;
  double stretch_ = 1.0;
};

/// Points of the curve.
struct Curve {
  std::vector<double> theta;  ///< The file's: angle - pi / 2.
  std::vector<double> rho;
};

Curve curve_of(const Lens& lens, std::size_t points) {
  Curve curve;
  for (std::size_t i = 0; i < points; ++i) {
    const double angle = lens.largest_angle() * static_cast<double>(i) / static_cast<double>(points - 1);
    // At the end of the domain rounding decides whether there is a pixel.
    const std::optional<double> rho = lens.radius(angle);
    if (!rho) continue;
    curve.theta.push_back(angle - std::numbers::pi / 2.0);
    curve.rho.push_back(*rho);
  }
  return curve;
}

/// In the order of operations of world2cam, which is what the numbers are for.
double evaluate(std::span<const double> coefficients, double theta) {
  double rho = coefficients.front();
  double power = 1.0;
  for (const double coefficient : coefficients.subspan(1)) {
    power *= theta;
    rho += power * coefficient;
  }
  return rho;
}

double largest_error(const Curve& curve, std::span<const double> coefficients) {
  double worst = 0.0;
  for (std::size_t i = 0; i < curve.theta.size(); ++i) {
    const double error = std::abs(evaluate(coefficients, curve.theta[i]) - curve.rho[i]);
    if (!(error <= worst)) worst = std::isfinite(error) ? error : HUGE_VAL;
  }
  return worst;
}

constexpr std::size_t kCheckedPoints = 2001;

constexpr std::size_t kNodes = 512;

/// The curve at Chebyshev's nodes, where a fit does not oscillate towards the ends. They are inside the ends, so all have a
/// pixel.
Curve chebyshev_nodes(const Lens& lens) {
  Curve nodes;
  for (std::size_t j = 0; j < kNodes; ++j) {
    const double x = std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / kNodes);
    const double angle = 0.5 * lens.largest_angle() * (x + 1.0);
    nodes.theta.push_back(angle - std::numbers::pi / 2.0);
    nodes.rho.push_back(lens.radius(angle).value_or(0.0));
  }
  return nodes;
}

/// Chebyshev coefficients of the curve over its angles.
std::vector<long double> chebyshev_series(const Lens& lens) {
  const std::vector<double> rho = chebyshev_nodes(lens).rho;
  std::vector<long double> series(kMostCoefficients);
  for (std::size_t k = 0; k < series.size(); ++k) {
    long double sum = 0.0L;
    for (std::size_t j = 0; j < kNodes; ++j) {
      sum += rho[j] * std::cos(std::numbers::pi_v<long double> * static_cast<long double>(k) *
                               (static_cast<long double>(j) + 0.5L) / kNodes);
    }
    series[k] = sum * (k == 0 ? 1.0L : 2.0L) / kNodes;
  }
  return series;
}

/// sum c_k T_k(x), x = scale theta + shift, as powers of theta; Clenshaw's recurrence on polynomials. Long double: the powers
/// of theta are a poor basis, and what they cost should be what a double costs their reader, no more.
std::vector<double> powers_of_theta(std::span<const long double> series, long double scale, long double shift) {
  const std::size_t count = series.size();
  std::vector<long double> next(count);
  std::vector<long double> after(count);
  const auto times_x = [&](const std::vector<long double>& p, std::size_t i) {
    return shift * p[i] + (i > 0 ? scale * p[i - 1] : 0.0L);
  };
  std::vector<long double> result(count);
  for (std::size_t k = count; k-- > 0;) {
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = (k == 0 ? 1.0L : 2.0L) * times_x(next, i) - after[i] + (i == 0 ? series[k] : 0.0L);
    }
    after = next;
    next = result;
  }
  std::vector<double> coefficients(count);
  std::ranges::transform(result, coefficients.begin(), [](long double value) { return static_cast<double>(value); });
  return coefficients;
}

}  // namespace

double inverse_error(const Camera& camera, std::span<const double> coefficients) {
  if (coefficients.empty()) return HUGE_VAL;
  const Lens lens(camera);
  return lens.stretch() * largest_error(curve_of(lens, kCheckedPoints), coefficients);
}

InversePolynomial fit_inverse(const Camera& camera, std::size_t most) {
  constexpr double kGoal = 1e-6;   // px
  constexpr double kMargin = 0.8;  // between the points that are checked
  const Lens lens(camera);
  const Curve curve = curve_of(lens, kCheckedPoints);
  const std::vector<long double> series = chebyshev_series(lens);
  // x = -1 .. 1 for theta = -pi / 2 .. largest angle - pi / 2.
  const long double scale = 2.0L / static_cast<long double>(lens.largest_angle());
  const long double shift = scale * std::numbers::pi_v<long double> / 2.0L - 1.0L;
  InversePolynomial best;
  best.error_px = HUGE_VAL;
  for (std::size_t count = 2; count <= most; ++count) {
    std::vector<double> coefficients = powers_of_theta(std::span(series).first(count), scale, shift);
    const double error = lens.stretch() * largest_error(curve, coefficients);
    if (error < best.error_px) best = {std::move(coefficients), error};
    if (best.error_px <= kMargin * kGoal) break;
  }
  // Where the series needs so many terms that rounding eats them (lenses of pinhole cameras, whose curve ends near a pole), a
  // longer polynomial of smaller terms is better.
  if (best.error_px > kGoal) {
    const Curve nodes = chebyshev_nodes(lens);
    for (const std::size_t count : {20U, 24U, 32U, 40U, 48U, 64U}) {
      if (count > most) break;
      std::vector<double> coefficients = fit_powers(nodes.theta, nodes.rho, count);
      const double error = lens.stretch() * largest_error(curve, coefficients);
      if (error < best.error_px) best = {std::move(coefficients), error};
      if (best.error_px <= kMargin * kGoal) break;
    }
  }
  return best;
}

}  // namespace fca::ocamcalib
