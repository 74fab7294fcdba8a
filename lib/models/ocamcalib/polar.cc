// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ocamcalib.h>

#include "../../convert/bound/polar_terms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace fca {

namespace internal {
namespace {

/// F(rho, angle) = g(rho) sin - rho cos, whose root is ocamcalib's radius, and dF/drho.
struct ImplicitRadius {
  std::array<double, 9> g{};             ///< The height of the ray ahead of the camera, ascending.
  std::array<double, 8> g_derivative{};  ///< dg/drho
  std::size_t degree = 0;

  explicit ImplicitRadius(const double* a) {
    for (std::size_t k = 0; k < g.size(); ++k) {
      g[k] = -a[k];
      if (k > 0) g_derivative[k - 1] = static_cast<double>(k) * g[k];
      if (a[k] != 0.0) degree = k;
    }
  }

  /// Horner up to the last coefficient that is not 0.
  template <std::size_t N>
  static Ball at(const std::array<double, N>& coefficients, std::size_t last, const Ball& x) {
    Ball result;
    for (std::size_t k = std::min(last, N - 1) + 1; k-- > 0;) result = exactly(coefficients[k]) + result * x;
    return result;
  }
  [[nodiscard]] Ball value(const Ball& rho, const Ball& sine, const Ball& cosine) const {
    return at(g, degree, rho) * sine - rho * cosine;
  }
  [[nodiscard]] Ball derivative(const Ball& rho, const Ball& sine, const Ball& cosine) const {
    return at(g_derivative, degree > 0 ? degree - 1 : 0, rho) * sine - cosine;
  }
};

/// The only rho near `guess` with F(rho, x) = 0, for every angle x of the ball: interval Newton (Moore 1966). If
/// guess - F(guess) / F'(X) lies inside X, X holds exactly one root for each x, and that is where it lies.
Ball enclose_root(const ImplicitRadius& f, double guess, const Ball& sine, const Ball& cosine) {
  const Ball centre = exactly(guess);
  const Ball residual = f.value(centre, sine, cosine);
  double rad = 2.0 * (residual / f.derivative(centre, sine, cosine)).magnitude();
  constexpr int kTries = 4;
  for (int i = 0; i < kTries; ++i, rad *= 2.0) {
    const Ball step = residual / f.derivative(Ball{guess, rad}, sine, cosine);
    const Ball next = centre - step;
    if (std::abs(next.mid - guess) + next.rad < rad) return next;
  }
  return unknown();
}

/// A polynomial of a series that becomes known coefficient by coefficient.
class PolynomialOf {
 public:
  using Coefficients = std::array<Ball, 9>;
  PolynomialOf(const Coefficients& c, std::size_t degree, const Series& x) : c_(c), degree_(degree), x_(x) {}

  /// Its coefficient number k, after all before it, once x is known up to that number: Horner's scheme.
  Ball coefficient(std::size_t k) {
    Ball result = k == 0 ? c_[degree_] : Ball{};
    for (std::size_t j = degree_; j-- > 0;) {
      sums_[j][k] = result;
      ProductSum product;
      for (std::size_t i = 0; i <= (j + 1 == degree_ ? 0 : k); ++i) product.add(sums_[j][i], x_[k - i]);
      result = k == 0 ? c_[j] + product.ball() : product.ball();
    }
    return result;
  }

 private:
  const Coefficients& c_;
  std::size_t degree_;
  const Series& x_;
  std::array<Series, std::tuple_size_v<Coefficients>> sums_;  ///< Before each multiplication with x.
};

/// The coefficients of rho(angle) after the first one, from the differential equation rho' h(rho) = g(rho)^2 + rho^2,
/// h(rho) = g - rho dg/drho: what angle = atan2(rho, g(rho)) says of its derivative.
void continue_radius(const ImplicitRadius& f, Series& rho) {
  PolynomialOf::Coefficients g;
  PolynomialOf::Coefficients h;
  for (std::size_t k = 0; k < g.size(); ++k) {
    g[k] = exactly(f.g[k]);
    h[k] = exactly(1.0 - static_cast<double>(k)) * g[k];
  }
  PolynomialOf g_of_rho(g, f.degree, rho);
  PolynomialOf h_of_rho(h, f.degree, rho);
  Series g_series;
  Series h_series;
  Series derivative;
  for (std::size_t k = 0; k < kOrder; ++k) {
    g_series[k] = g_of_rho.coefficient(k);
    h_series[k] = h_of_rho.coefficient(k);
    ProductSum heights;
    ProductSum radii;
    for (std::size_t i = 0; i <= k; ++i) {
      heights.add(g_series[i], g_series[k - i]);
      radii.add(rho[i], rho[k - i]);
    }
    ProductSum known;
    for (std::size_t i = 1; i <= k; ++i) known.add(h_series[i], derivative[k - i]);
    derivative[k] = (heights.ball() + radii.ball() - known.ball()) / h_series[0];
    rho[k + 1] = derivative[k] / exactly(static_cast<double>(k + 1));
  }
}

}  // namespace

}  // namespace internal

void Ocamcalib::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::ImplicitRadius;
  using internal::Series;
  using internal::unknown;
  constexpr std::size_t kA = 5;
  const ImplicitRadius f(p + kA);
  // The model's own root of the domain at the centre, in the image of a ray along x.
  const double ray[3] = {std::sin(angle.at.mid), 0.0, std::cos(angle.at.mid)};
  double pixel[2];
  Series rho;
  if (angle.at.mid == 0.0 || project(p, ray, pixel)) {
    const double guess = angle.at.mid == 0.0 ? 0.0 : pixel[0] - p[0];
    rho[0] = enclose_root(f, guess, angle.sine[0], angle.cosine[0]);
  } else {
    rho[0] = unknown();
  }
  continue_radius(f, rho);
  // u = cx + Y + e X, v = cy + c X + d Y with (X, Y) = rho (sin phi, cos phi)
  set_radial(form, {p[0], p[1]}, {1.0, p[4], p[3], p[2]}, rho);
}

}  // namespace fca
