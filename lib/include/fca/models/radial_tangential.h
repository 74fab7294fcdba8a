// SPDX-License-Identifier: BSD-3-Clause
// Radial-tangential distortion of the normalised plane, for any radial factor L(r^2): radtan, mei (a polynomial) and rational
// (a quotient of two).
//
//   q      = the coefficients, of which q[2], q[3] = p1, p2
//   m_x    = x L + 2 p1 x y + p2 (r^2 + 2 x^2)
//   m_y    = y L + p1 (r^2 + 2 y^2) + 2 p2 x y
//   domain : r < r_max, the disc on which the Jacobian is positive definite
//
// The distortion is the gradient of Phi(x, y) = F(r) + r^2 (p2 x + p1 y), F' = r L. So its Jacobian is symmetric, and where
// that is positive definite on a disc, Phi is strictly convex there: the distortion is injective on the disc, and its inverse
// is the minimum of Phi(x) - x . m, which damped Newton always finds.
//
// In polar coordinates, with P = |(p1, p2)| and A = d(r L)/dr, the Jacobian's determinant at azimuth phi from that of (p2, p1)
// is A L - 4 P^2 r^2 + 2 P r (A + 3 L) cos phi + 16 P^2 r^2 cos^2 phi. It is smallest at cos phi = -1, and there
// (A - 6 P r)(L - 2 P r), as long as A + 3 L >= 16 P r (else it is smaller at another azimuth); and A > 6 P r up to r implies
// L > 3 P r. So r_max is the first root of A - 6 P r or A + 3 L - 16 P r. Where the second comes first (6 of a million random
// lenses) the disc is a few percent smaller than the largest possible one.
#pragma once

#include <fca/models/model_traits.h>
#include <fca/models/polynomial.h>

#include <algorithm>

namespace fca::internal {

/// The length of a vector.
inline double length(double x, double y) { return std::sqrt(x * x + y * y); }

/// The shift of a thin prism of two orders, r^2 (s1 + s2 r^2) along x and r^2 (s3 + s4 r^2) along y, whose coefficients begin
/// at q[kFirst].
template <std::size_t kFirst>
struct ThinPrism {
  /// The lengths of (s1, s3) and (s2, s4).
  static double linear(const double* q) { return length(q[kFirst], q[kFirst + 2]); }
  static double square(const double* q) { return length(q[kFirst + 1], q[kFirst + 3]); }
  /// How far it moves a point at r, at most.
  static double longest(const double* q, double r2) { return r2 * (linear(q) + r2 * square(q)); }

  template <class T>
  static void add(const T* q, const T& r2, T* m) {
    m[0] += r2 * (q[kFirst] + r2 * q[kFirst + 1]);
    m[1] += r2 * (q[kFirst + 2] + r2 * q[kFirst + 3]);
  }
  /// d(m_x, m_y)/d(r^2).
  static std::array<double, 2> derivatives(const double* q, double r2) {
    return {q[kFirst] + 2.0 * r2 * q[kFirst + 1], q[kFirst + 2] + 2.0 * r2 * q[kFirst + 3]};
  }
};

/// A thin prism adds a shift that depends on r^2 alone. The Jacobian is then no longer symmetric, but where its symmetric part
/// is positive definite on a disc, the map is injective there, too. The prism takes at most its gradient's length from each
/// eigenvalue of that part, as if L and A were smaller by it; that L stays above 2 P r is then a condition of its own.
///
/// `Radial` is the factor L:
///   kCount                      number of coefficients q
///   factor(q, r2)               L, for double and for automatic differentiation
///   factor_and_derivative(q, r2, L, derivative)
///                               L and dL/d(r^2)
///   defined(q, r2)              does L have a value there?
///   inside(q, r), max_radius(q) the disc
///   kPrism                      true: add(q, r2, m) adds a thin prism's shift, derivatives(q, r2) are its derivatives by
///                               r2, and longest(q, r2) is its length at most
template <class Radial>
struct TangentialOver {
  /// false outside the disc, if that is asked.
  template <bool kWithinDomain, class T>
  static bool distort(const T* q, const T& x, const T& y, T* m) {
    const T r2 = x * x + y * y;
    double values[Radial::kCount];
    std::transform(q, q + Radial::kCount, values, [](const T& value) { return value_of(value); });
    if (!Radial::defined(values, value_of(r2))) return false;
    if (kWithinDomain && !inside(values, std::sqrt(value_of(r2)))) return false;
    apply(q, x, y, r2, m);
    return true;
  }

  /// m -> the (x, y) of the disc that has it; false if there is none. First Newton from m, nearly always enough; else from the
  /// solution without tangential terms, kept inside the disc.
  static bool undistort(const double* q, const double* m, double* xy) {
    xy[0] = m[0];
    xy[1] = m[1];
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    if (newton(q, m, kUnlimited, xy) && inside(q, length(xy[0], xy[1]))) return true;

    const double limit = max_radius(q);
    const double radius = length(m[0], m[1]);
    constexpr double kSquareOverflows = 1e150;
    if (!(radius < kSquareOverflows)) return false;
    const auto radial = [q](double r, double& value, double& derivative) {
      Radial::factor_and_derivative(q, r * r, value, derivative);
      derivative = value + 2.0 * r * r * derivative;
      value *= r;
    };
    double r = std::min(radius, limit);
    if (!invert_increasing(radial, radius, limit, r)) {
      double largest = 0.0;
      double derivative = 0.0;
      radial(limit, largest, derivative);
      // The tangential terms are at most 3 P r^2 long.
      double moved = 3.0 * length(q[2], q[3]) * limit * limit;
      if constexpr (Radial::kPrism) moved += Radial::longest(q, limit * limit);
      if (!(radius < largest + moved)) return false;
      r = 0.999 * limit;
    }
    xy[0] = radius > 0.0 ? m[0] * (r / radius) : 0.0;
    xy[1] = radius > 0.0 ? m[1] * (r / radius) : 0.0;
    return newton(q, m, limit, xy);
  }

  /// r_max; infinite where the distortion never ends.
  static double max_radius(const double* q) { return Radial::max_radius(q); }
  static bool inside(const double* q, double r) { return Radial::inside(q, r); }

 private:
  template <class T>
  static void apply(const T* q, const T& x, const T& y, const T& r2, T* m) {
    const T radial = Radial::factor(q, r2);
    const T xy2 = T(2.0) * x * y;
    m[0] = x * radial + q[2] * xy2 + q[3] * (r2 + T(2.0) * x * x);
    m[1] = y * radial + q[2] * (r2 + T(2.0) * y * y) + q[3] * xy2;
    if constexpr (Radial::kPrism) Radial::add(q, r2, m);
  }

  static void jacobian(const double* q, double x, double y, double* j) {
    double radial = 0.0;
    double derivative = 0.0;
    Radial::factor_and_derivative(q, x * x + y * y, radial, derivative);
    const double radial_derivative = 2.0 * derivative;  // dL/dx = x * this
    j[0] = radial + x * x * radial_derivative + 2.0 * q[2] * y + 6.0 * q[3] * x;
    j[1] = x * y * radial_derivative + 2.0 * q[2] * x + 2.0 * q[3] * y;
    j[2] = j[1];
    j[3] = radial + y * y * radial_derivative + 6.0 * q[2] * y + 2.0 * q[3] * x;
    if constexpr (Radial::kPrism) {
      const auto [u, v] = Radial::derivatives(q, x * x + y * y);
      j[0] += 2.0 * x * u;
      j[1] += 2.0 * y * u;
      j[2] += 2.0 * x * v;
      j[3] += 2.0 * y * v;
    }
  }

  /// Damped Newton from the given (x, y): halves the step until it stays inside the disc and the residual does not grow.
  static bool newton(const double* q, const double* m, double limit, double* xy) {
    constexpr double kRounding = 1e-13;
    const double tolerance = kRounding * (1.0 + length(m[0], m[1]));
    double value[2];
    apply(q, xy[0], xy[1], xy[0] * xy[0] + xy[1] * xy[1], value);
    double residual = length(value[0] - m[0], value[1] - m[1]);
    constexpr int kMaxSteps = 50;
    for (int i = 0; i < kMaxSteps && residual > 0.0; ++i) {
      double j[4];  // row by row
      jacobian(q, xy[0], xy[1], j);
      const double determinant = j[0] * j[3] - j[1] * j[2];
      if (!(determinant > 0.0)) return false;
      const double ex = value[0] - m[0];
      const double ey = value[1] - m[1];
      double dx = (j[3] * ex - j[1] * ey) / determinant;
      double dy = (j[0] * ey - j[2] * ex) / determinant;
      // The step after a very short one would be about its square.
      const double step = length(dx, dy) / (1.0 + length(xy[0], xy[1]));
      const bool last = step <= 1e-10;
      const double previous = residual;
      double next[2];
      bool accepted = false;
      constexpr int kMaxTries = 60;
      for (int halving = 0; halving < kMaxTries && !accepted; ++halving, dx *= 0.5, dy *= 0.5) {
        next[0] = xy[0] - dx;
        next[1] = xy[1] - dy;
        if (!(length(next[0], next[1]) < limit)) continue;
        apply(q, next[0], next[1], next[0] * next[0] + next[1] * next[1], value);
        residual = length(value[0] - m[0], value[1] - m[1]);
        accepted = residual <= previous;
      }
      // No step helps: at the rounding floor (of the residual or, where that is steep, of the point), or against the disc's
      // edge because no ray has this pixel.
      if (!accepted) return previous <= tolerance || step <= kRounding;
      xy[0] = next[0];
      xy[1] = next[1];
      if (last && step <= kRounding) return true;
      if (residual == previous) break;
      if (last && residual <= tolerance) return true;
    }
    return residual <= tolerance;
  }
};

/// L = 1 + k1 r^2 + k2 r^4 + k3 r^6, q = k1 k2 p1 p2 k3: A = 1 + 3 k1 r^2 + 5 k2 r^4 + 7 k3 r^6.
struct PolynomialFactor {
  static constexpr std::size_t kCount = 5;
  static constexpr bool kPrism = false;

  template <class T>
  static T factor(const T* q, const T& r2) {
    return T(1.0) + r2 * (q[0] + r2 * (q[1] + r2 * q[4]));
  }
  static void factor_and_derivative(const double* q, double r2, double& value, double& derivative) {
    value = factor(q, r2);
    derivative = q[0] + r2 * (2.0 * q[1] + r2 * 3.0 * q[4]);
  }
  static bool defined(const double* /*q*/, double /*r2*/) { return true; }

  static bool inside(const double* q, double r) {
    return positive_on(radial_derivative(q), r) && positive_on(other_azimuths(q), r);
  }
  static double max_radius(const double* q) {
    return positive_until(other_azimuths(q), positive_until(radial_derivative(q), std::numeric_limits<double>::infinity()));
  }

 private:
  /// A - 6 P r as a polynomial in r.
  static std::array<double, 7> radial_derivative(const double* q) {
    return {1.0, -6.0 * length(q[2], q[3]), 3.0 * q[0], 0.0, 5.0 * q[1], 0.0, 7.0 * q[4]};
  }
  /// A + 3 L - 16 P r as a polynomial in r.
  static std::array<double, 7> other_azimuths(const double* q) {
    return {4.0, -16.0 * length(q[2], q[3]), 6.0 * q[0], 0.0, 8.0 * q[1], 0.0, 10.0 * q[4]};
  }
};

/// The distortion of radtan, and with k3 = 0 of mei.
using RadialTangential = TangentialOver<PolynomialFactor>;

}  // namespace fca::internal
