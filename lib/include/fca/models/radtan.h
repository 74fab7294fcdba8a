// SPDX-License-Identifier: BSD-3-Clause
// Pinhole with radial-tangential distortion (Brown 1971; in the form of OpenCV's calib3d).
//
//   p      = fx fy cx cy [px]  k1 k2 p1 p2 k3
//   (x, y) = ray / z,  r^2 = x^2 + y^2,  L = 1 + k1 r^2 + k2 r^4 + k3 r^6
//   m_x    = x L + 2 p1 x y + p2 (r^2 + 2 x^2)
//   m_y    = y L + p1 (r^2 + 2 y^2) + 2 p2 x y
//   pixel  = (fx m_x + cx, fy m_y + cy)
//   domain : z > 0 and r < r_max, the disc on which the distortion's Jacobian is positive definite (see below)
//
// Parameter order is that of OpenCV's files (k1 k2 p1 p2 k3), not the paper's (ERRATA 10). With four coefficients k3 is 0.
//
// Called: Kalibr pinhole-radtan (no k3); ORB-SLAM3 PinHole; OpenCV 4- and 5-vectors; ROS plumb_bob; "Brown-Conrady".
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>
#include <fca/models/polynomial.h>

#include <algorithm>
#include <numbers>

namespace fca {

namespace internal {

/// The distortion alone, on the normalised plane: q = k1 k2 p1 p2 k3. Shared with Mei.
///
/// It is the gradient of Phi(x, y) = F(r) + r^2 (p2 x + p1 y), F' = r L. So its Jacobian is symmetric, and where that is
/// positive definite on a disc, Phi is strictly convex there: the distortion is injective on the disc, and its inverse is the
/// minimum of Phi(x) - x . m, which damped Newton always finds.
///
/// In polar coordinates, with P = |(p1, p2)| and A = 1 + 3 k1 r^2 + 5 k2 r^4 + 7 k3 r^6, the Jacobian's determinant at the
/// worst azimuth is (A - 6 P r)(L - 2 P r), as long as A + 3 L >= 16 P r (else it is smaller at another azimuth); and A > 6 P r
/// up to r implies L > 3 P r. So r_max is the first root of A - 6 P r or A + 3 L - 16 P r. Where the second comes first (6 of a
/// million random lenses) the disc is a few percent smaller than the largest possible one.
struct RadialTangential {
  /// false outside the disc, if that is asked.
  template <bool kWithinDomain, class T>
  static bool distort(const T* q, const T& x, const T& y, T* m) {
    const T r2 = x * x + y * y;
    const double values[5] = {value_of(q[0]), value_of(q[1]), value_of(q[2]), value_of(q[3]), value_of(q[4])};
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
    const auto radial = [q](double r, double& value, double& slope) {
      const double t = r * r;
      value = r * (1.0 + t * (q[0] + t * (q[1] + t * q[4])));
      slope = 1.0 + t * (3.0 * q[0] + t * (5.0 * q[1] + t * 7.0 * q[4]));
    };
    double r = std::min(radius, limit);
    if (!invert_increasing(radial, radius, limit, r)) {
      double largest = 0.0;
      double slope = 0.0;
      radial(limit, largest, slope);
      // The tangential terms are at most 3 P r^2 long.
      if (!(radius < largest + 3.0 * length(q[2], q[3]) * limit * limit)) return false;
      r = 0.999 * limit;
    }
    xy[0] = radius > 0.0 ? m[0] * (r / radius) : 0.0;
    xy[1] = radius > 0.0 ? m[1] * (r / radius) : 0.0;
    return newton(q, m, limit, xy);
  }

  /// r_max; infinite where the distortion never folds.
  static double max_radius(const double* q) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return positive_until(other_azimuths(q), positive_until(radial_slope(q), kInfinity));
  }

  static bool inside(const double* q, double r) { return positive_on(radial_slope(q), r) && positive_on(other_azimuths(q), r); }

 private:
  static double length(double x, double y) { return std::sqrt(x * x + y * y); }

  template <class T>
  static void apply(const T* q, const T& x, const T& y, const T& r2, T* m) {
    const T radial = T(1.0) + r2 * (q[0] + r2 * (q[1] + r2 * q[4]));
    const T xy2 = T(2.0) * x * y;
    m[0] = x * radial + q[2] * xy2 + q[3] * (r2 + T(2.0) * x * x);
    m[1] = y * radial + q[2] * (r2 + T(2.0) * y * y) + q[3] * xy2;
  }

  static void jacobian(const double* q, double x, double y, double* j) {
    const double r2 = x * x + y * y;
    const double radial = 1.0 + r2 * (q[0] + r2 * (q[1] + r2 * q[4]));
    const double radial_slope = 2.0 * (q[0] + r2 * (2.0 * q[1] + r2 * 3.0 * q[4]));  // dL/dr^2 * 2: dL/dx = x * this
    j[0] = radial + x * x * radial_slope + 2.0 * q[2] * y + 6.0 * q[3] * x;
    j[1] = x * y * radial_slope + 2.0 * q[2] * x + 2.0 * q[3] * y;
    j[2] = radial + y * y * radial_slope + 6.0 * q[2] * y + 2.0 * q[3] * x;
  }

  /// Damped Newton from the given (x, y): halves the step until it stays inside the disc and the residual does not grow.
  static bool newton(const double* q, const double* m, double limit, double* xy) {
    const double tolerance = 1e-13 * (1.0 + length(m[0], m[1]));
    double value[2];
    apply(q, xy[0], xy[1], xy[0] * xy[0] + xy[1] * xy[1], value);
    double residual = length(value[0] - m[0], value[1] - m[1]);
    constexpr int kMaxSteps = 50;
    for (int i = 0; i < kMaxSteps && residual > 0.0; ++i) {
      double j[3];  // xx, xy, yy
      jacobian(q, xy[0], xy[1], j);
      const double determinant = j[0] * j[2] - j[1] * j[1];
      if (!(determinant > 0.0)) return false;
      const double ex = value[0] - m[0];
      const double ey = value[1] - m[1];
      double dx = (j[2] * ex - j[1] * ey) / determinant;
      double dy = (j[0] * ey - j[1] * ex) / determinant;
      // The step after a very short one would be about its square.
      const bool last = length(dx, dy) <= 1e-10 * (1.0 + length(xy[0], xy[1]));
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
      // No step helps: at the rounding floor, or against the disc's edge because no ray has this pixel.
      if (!accepted) return previous <= tolerance;
      xy[0] = next[0];
      xy[1] = next[1];
      if (last || residual == previous) break;
    }
    return residual <= tolerance;
  }

  /// A - 6 P r as a polynomial in r.
  static std::array<double, 7> radial_slope(const double* q) {
    return {1.0, -6.0 * length(q[2], q[3]), 3.0 * q[0], 0.0, 5.0 * q[1], 0.0, 7.0 * q[4]};
  }
  /// A + 3 L - 16 P r as a polynomial in r.
  static std::array<double, 7> other_azimuths(const double* q) {
    return {4.0, -16.0 * length(q[2], q[3]), 6.0 * q[0], 0.0, 8.0 * q[1], 0.0, 10.0 * q[4]};
  }
};

}  // namespace internal

struct Radtan : internal::FocalLengthsFirst {
  static constexpr std::string_view kId = "radtan";
  static constexpr std::string_view kTitle = "Pinhole with radial-tangential distortion";
  static constexpr std::array<std::string_view, 6> kAliases = {"rt",        "pinhole-radtan", "radial-tangential",
                                                               "plumb-bob", "brown",          "brown-conrady"};
  static constexpr std::array kParameters = {common_parameter::kFx,
                                             common_parameter::kFy,
                                             common_parameter::kCx,
                                             common_parameter::kCy,
                                             common_parameter::coefficient("k1"),
                                             common_parameter::coefficient("k2"),
                                             common_parameter::coefficient("p1"),
                                             common_parameter::coefficient("p2"),
                                             common_parameter::coefficient("k3")};

  template <class T>
  static bool project(const T* p, const T* ray, T* pixel) {
    return map<true>(p, ray, pixel);
  }
  template <class T>
  static bool formula(const T* p, const T* ray, T* pixel) {
    return map<false>(p, ray, pixel);
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    double m[2];
    if (!internal::to_plane(p, pixel, m[0], m[1])) return false;
    if (!internal::RadialTangential::undistort(p + 4, m, ray)) return false;
    ray[2] = 1.0;
    return internal::normalise(ray);
  }

  static double max_angle(const double* p) { return std::atan(internal::RadialTangential::max_radius(p + 4)); }

  /// All coefficients are linear: m - (x, y) = k1 r^2 (x, y) + ...
  static constexpr int kStarts = 1;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int /*start*/, double* p) {
    begin(centre, p);
    internal::LinearFit<5> fit;
    for (const Correspondence& s : samples) {
      if (!(s.ray[2] > 0.0)) continue;
      const double x = s.ray[0] / s.ray[2];
      const double y = s.ray[1] / s.ray[2];
      const double r2 = x * x + y * y;
      const double mx = (s.pixel[0] - p[2]) / p[0];
      const double my = (s.pixel[1] - p[3]) / p[1];
      fit.add({x * r2, x * r2 * r2, 2.0 * x * y, r2 + 2.0 * x * x, x * r2 * r2 * r2}, mx - x, s.weight);
      fit.add({y * r2, y * r2 * r2, r2 + 2.0 * y * y, 2.0 * x * y, y * r2 * r2 * r2}, my - y, s.weight);
    }
    fit.solve(p + 4);
  }

 private:
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    if (!(internal::value_of(ray[2]) > 0.0)) return false;
    T m[2];
    if (!internal::RadialTangential::distort<kWithinDomain>(p + 4, T(ray[0] / ray[2]), T(ray[1] / ray[2]), m)) return false;
    internal::to_pixel(p, m[0], m[1], pixel);
    return true;
  }
};

static_assert(CameraModelType<Radtan>);

}  // namespace fca
