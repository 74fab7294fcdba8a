// SPDX-License-Identifier: BSD-3-Clause
// Project Aria's fisheye model: six radial coefficients, then tangential distortion and a thin prism, both of the radially
// distorted point (projectaria_tools@90f70ff, FisheyeRadTanThinPrism.h).
//
//   p      = fx fy cx cy [px]  k0 .. k5  p0 p1  s0 s1 s2 s3
//   theta  = atan2(|(X, Y)|, Z),  R = theta (1 + k0 theta^2 + k1 theta^4 + ... + k5 theta^12)
//   (x, y) = R (X, Y) / |(X, Y)|,  q = R^2
//   m_x    = x + p0 (2 x^2 + q) + 2 p1 x y + s0 q + s1 q^2
//   m_y    = y + p1 (2 y^2 + q) + 2 p0 x y + s2 q + s3 q^2
//   pixel  = (fx m_x + cx, fy m_y + cy)
//   domain : theta < pi, dR/dtheta > 0 on all of [0, theta], and R on the disc on which the Jacobian's symmetric part of what
//            follows is positive definite (radial_tangential.h)
//
// The coefficients have Aria's names: k0 is kb4's k1, p0 is OpenCV's p2 and p1 its p1.
//
// Called: FisheyeRadTanThinPrism, Fisheye624 (Aria, nerfstudio, OpenSfM); COLMAP RAD_TAN_THIN_PRISM_FISHEYE.
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>
#include <fca/models/polynomial.h>
#include <fca/models/radial_tangential.h>

#include <algorithm>
#include <numbers>

namespace fca {

namespace internal {

/// L = 1 with a thin prism of two orders, q = 0 0 p1 p2 s0 s1 s2 s3.
struct UnitPrismFactor : ThinPrism<4> {
  static constexpr std::size_t kCount = 8;
  static constexpr bool kPrism = true;

  template <class T>
  static T factor(const T* /*q*/, const T& /*r2*/) {
    return T(1.0);
  }
  static void factor_and_derivative(const double* /*q*/, double /*r2*/, double& value, double& derivative_of) {
    value = 1.0;
    derivative_of = 0.0;
  }
  static bool defined(const double* /*q*/, double /*r2*/) { return true; }
  static bool inside(const double* q, double r) { return positive_on(condition(q), r); }
  static double max_radius(const double* q) { return positive_until(condition(q), std::numeric_limits<double>::infinity()); }

 private:
  /// 1 - 6 P r without what the prism takes of it. The other conditions of the disc follow from it where L = A = 1.
  static std::array<double, 4> condition(const double* q) {
    return {1.0, -6.0 * length(q[2], q[3]) - 2.0 * linear(q), 0.0, -4.0 * square(q)};
  }
};

}  // namespace internal

struct Fisheye624 : internal::FocalLengthsFirst, internal::RayMap<Fisheye624> {
  static constexpr std::string_view kId = "fisheye624";
  static constexpr std::string_view kTitle = "Project Aria's fisheye model (6 radial, 2 tangential, 4 thin prism)";
  static constexpr std::string_view kContains = "kb4";
  static constexpr std::array<std::string_view, 4> kAliases = {"rad-tan-thin-prism-fisheye", "fisheye-rad-tan-thin-prism",
                                                               "rad-tan-thin-prism", "aria"};
  static constexpr std::array kParameters = {common_parameter::kFx,
                                             common_parameter::kFy,
                                             common_parameter::kCx,
                                             common_parameter::kCy,
                                             common_parameter::coefficient("k0"),
                                             common_parameter::coefficient("k1"),
                                             common_parameter::coefficient("k2"),
                                             common_parameter::coefficient("k3"),
                                             common_parameter::coefficient("k4"),
                                             common_parameter::coefficient("k5"),
                                             common_parameter::coefficient("p0"),
                                             common_parameter::coefficient("p1"),
                                             common_parameter::coefficient("s0"),
                                             common_parameter::coefficient("s1"),
                                             common_parameter::coefficient("s2"),
                                             common_parameter::coefficient("s3")};
  static constexpr bool kKeptOnly = true;

  static bool unproject(const double* p, const double* pixel, double* ray) {
    const std::array<double, 8> q = further_terms(p);
    double m[2];
    double xy[2];
    if (!internal::to_plane(p, pixel, m[0], m[1]) || !Distortion::undistort(q.data(), m, xy)) return false;
    const double radius = internal::length(xy[0], xy[1]);
    double theta = 0.0;
    if (!angle_of_radius(p, radius, theta)) return false;
    internal::ray_at_angle(theta, xy[0], xy[1], radius, ray);
    return true;
  }

  static double max_angle(const double* p) {
    const double growing = std::sqrt(positive_until(derivative_of(p), std::numbers::pi * std::numbers::pi));
    const double disc = Distortion::max_radius(further_terms(p).data());
    const auto radius = [p](double theta, double& value, double& derivative) { radius_at(p, theta, value, derivative); };
    double theta = growing;
    return invert_increasing(radius, disc, growing, theta) ? theta : growing;
  }

  static constexpr int kStarts = 1;
  /// Without tangential distortion and prism k0..k5 are linear in the radius.
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int /*start*/, double* p) {
    begin(centre, p);
    internal::LinearFit<kRadialCount> fit;
    for (const Correspondence& s : samples) {
      const double theta = std::atan2(std::hypot(s.ray[0], s.ray[1]), s.ray[2]);
      const double radius = std::hypot((s.pixel[0] - p[2]) / p[0], (s.pixel[1] - p[3]) / p[1]);
      std::array<double, kRadialCount> row{};
      double power = theta;
      for (double& term : row) {
        power *= theta * theta;
        term = power;
      }
      fit.add(row, radius - theta, s.weight);
    }
    fit.solve(p + kRadial);
    std::fill(p + kTangential, p + kParameters.size(), 0.0);
  }

  // In lib/models/fisheye624.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  friend struct internal::RayMap<Fisheye624>;
  using Distortion = internal::TangentialOver<internal::UnitPrismFactor>;
  static constexpr std::size_t kRadial = 4;
  static constexpr std::size_t kRadialCount = 6;
  static constexpr std::size_t kTangential = kRadial + kRadialCount;

  /// As Distortion has them: p1 p2 in OpenCV's sense.
  template <class T>
  static std::array<T, 8> further_terms(const T* p) {
    return {T(0.0), T(0.0), p[11], p[10], p[12], p[13], p[14], p[15]};
  }

  /// R / theta of t = theta^2.
  template <class T>
  static T factor(const T* p, const T& t) {
    T sum = p[kRadial + kRadialCount - 1];
    for (std::size_t i = kRadialCount - 1; i-- > 0;) sum = p[kRadial + i] + t * sum;
    return T(1.0) + t * sum;
  }
  /// dR/dtheta as a polynomial in theta^2.
  static std::array<double, 7> derivative_of(const double* p) {
    return {1.0, 3.0 * p[4], 5.0 * p[5], 7.0 * p[6], 9.0 * p[7], 11.0 * p[8], 13.0 * p[9]};
  }
  static void radius_at(const double* p, double theta, double& value, double& derivative) {
    value = theta * factor(p, theta * theta);
    derivative = evaluate_polynomial(derivative_of(p), theta * theta);
  }

  static bool angle_of_radius(const double* p, double radius, double& theta) {
    const std::array<double, 7> derivative_coefficients = derivative_of(p);
    const auto at = [p](double x, double& value, double& derivative) { radius_at(p, x, value, derivative); };
    const auto inside = [&](double x) { return x < std::numbers::pi && positive_on(derivative_coefficients, x * x); };
    return invert_inside(
        at, radius, radius, inside, [&] { return max_angle(p); }, theta);
  }

  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    T plane[2];
    if (!internal::equidistant(ray, plane)) return false;
    const T t = plane[0] * plane[0] + plane[1] * plane[1];
    if (kWithinDomain) {
      std::array<double, kTangential> values;
      std::transform(p, p + kTangential, values.begin(), [](const T& value) { return internal::value_of(value); });
      const double angle = std::sqrt(internal::value_of(t));
      if (!(angle < std::numbers::pi) || !positive_on(derivative_of(values.data()), angle * angle)) return false;
    }
    const T scale = factor(p, t);
    const std::array<T, 8> q = further_terms(p);
    T m[2];
    if (!Distortion::distort<kWithinDomain>(q.data(), T(scale * plane[0]), T(scale * plane[1]), m)) return false;
    internal::to_pixel(p, m[0], m[1], pixel);
    return true;
  }
};

static_assert(CameraModelType<Fisheye624>);

}  // namespace fca
