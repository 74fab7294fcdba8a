// SPDX-License-Identifier: BSD-3-Clause
// Kannala-Brandt with four coefficients (Kannala & Brandt 2006, eq. 6, with the first coefficient in the focal length).
//
//   p      = fx fy cx cy [px]  k1 k2 k3 k4
//   r      = |(x, y)|,  theta = atan2(r, z)
//   d      = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8)
//   pixel  = (fx d x / r + cx, fy d y / r + cy)
//   domain : theta < pi and dd/dtheta > 0 on all of [0, theta]
//
// Differs from the paper (Lee, sec. II-D): its domain, all of R^3 but the origin, ignores that d may stop growing.
// Called: Kalibr pinhole-equidistant; cv::fisheye; ORB-SLAM3 KannalaBrandt8; "equidistant" in ROS; VINS KANNALA_BRANDT
// (k2..k5).
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>
#include <fca/models/polynomial.h>

#include <numbers>

namespace fca {

struct Kb4 : internal::FocalLengthsFirst, internal::RayMap<Kb4> {
  static constexpr std::string_view kId = "kb4";
  static constexpr std::string_view kTitle = "Kannala-Brandt";
  static constexpr bool kRound = true;
  static constexpr std::array<std::string_view, 12> kAliases = {
      "kb",          "kb8",  "kannala-brandt", "kannalabrandt",       "kannalabrandt8", "kannala-brandt4",
      "equidistant", "equi", "pinhole-equi",   "pinhole-equidistant", "fisheye",        "opencv-fisheye"};
  static constexpr std::array kParameters = {common_parameter::kFx,
                                             common_parameter::kFy,
                                             common_parameter::kCx,
                                             common_parameter::kCy,
                                             common_parameter::coefficient("k1"),
                                             common_parameter::coefficient("k2"),
                                             common_parameter::coefficient("k3"),
                                             common_parameter::coefficient("k4")};

  static bool unproject(const double* p, const double* pixel, double* ray) {
    double mx = 0.0;
    double my = 0.0;
    if (!internal::to_plane(p, pixel, mx, my)) return false;
    const double radius = std::sqrt(mx * mx + my * my);
    double theta = 0.0;
    if (!angle_of_radius(p, radius, theta)) return false;
    internal::ray_at_angle(theta, mx, my, radius, ray);
    return true;
  }

  static double max_angle(const double* p) {
    return std::sqrt(positive_until(derivative_of(p + 4), std::numbers::pi * std::numbers::pi));
  }

  /// theta, theta^3, ... theta^9 in the direction of (x, y), with f, f k1, ... f k4.
  static constexpr std::size_t kTerms = 5;
  static bool terms(const double* ray, double* along_u, double* along_v) {
    const double r = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1]);
    if (!(r > 0.0) && !(ray[2] > 0.0)) return false;
    const double theta = std::atan2(r, ray[2]);
    double power = r > 0.0 ? theta / r : 1.0 / ray[2];
    for (std::size_t i = 0; i < kTerms; ++i, power *= theta * theta) {
      along_u[i] = ray[0] * power;
      along_v[i] = ray[1] * power;
    }
    return true;
  }
  static void from_terms(const double* c, double aspect, const std::array<double, 2>& point, double* p) {
    begin({{c[0], aspect * c[0]}, point}, p);
    for (std::size_t i = 1; i < kTerms; ++i) p[3 + i] = c[i] / c[0];
  }

  /// k1..k4 are linear in the radius: one radial row per point (ERRATA 8), d - theta = k1 theta^3 + ...
  static constexpr int kStarts = 1;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int /*start*/, double* p) {
    begin(centre, p);
    internal::LinearFit<4> fit;
    for (const Correspondence& s : samples) {
      const double theta = std::atan2(std::hypot(s.ray[0], s.ray[1]), s.ray[2]);
      const double radius = std::hypot((s.pixel[0] - p[2]) / p[0], (s.pixel[1] - p[3]) / p[1]);
      const double t = theta * theta;
      fit.add({theta * t, theta * t * t, theta * t * t * t, theta * t * t * t * t}, radius - theta, s.weight);
    }
    fit.solve(p + 4);
  }

  // In lib/models/kb4.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);

 private:
  friend struct internal::RayMap<Kb4>;
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    using std::atan2;
    using std::sqrt;
    const T r2 = ray[0] * ray[0] + ray[1] * ray[1];
    if (!(internal::value_of(r2) > 0.0)) {  // on the axis, where r has no derivative
      if (!(internal::value_of(ray[2]) > 0.0)) return false;
      internal::to_pixel(p, T(ray[0] / ray[2]), T(ray[1] / ray[2]), pixel);
      return true;
    }
    const T r = sqrt(r2);
    const T theta = atan2(r, ray[2]);
    const double values[4] = {internal::value_of(p[4]), internal::value_of(p[5]), internal::value_of(p[6]),
                              internal::value_of(p[7])};
    const double angle = internal::value_of(theta);
    if (kWithinDomain && (!(angle < std::numbers::pi) || !positive_on(derivative_of(values), angle * angle))) return false;
    const T t = theta * theta;
    const T scale = theta * (T(1.0) + t * (p[4] + t * (p[5] + t * (p[6] + t * p[7])))) / r;
    internal::to_pixel(p, T(scale * ray[0]), T(scale * ray[1]), pixel);
    return true;
  }

  /// dd/dtheta as a polynomial in theta^2.
  static std::array<double, 5> derivative_of(const double* k) { return {1.0, 3.0 * k[0], 5.0 * k[1], 7.0 * k[2], 9.0 * k[3]}; }

  /// d(theta) = radius, from theta = radius.
  static bool angle_of_radius(const double* p, double radius, double& theta) {
    const std::array<double, 5> derivative_coefficients = derivative_of(p + 4);
    const auto d = [&](double x, double& value, double& derivative) {
      const double t = x * x;
      value = x * (1.0 + t * (p[4] + t * (p[5] + t * (p[6] + t * p[7]))));
      derivative = evaluate_polynomial(derivative_coefficients, t);
    };
    const auto inside = [&](double x) { return x < std::numbers::pi && positive_on(derivative_coefficients, x * x); };
    return invert_inside(
        d, radius, radius, inside, [&] { return max_angle(p); }, theta);
  }
};

static_assert(CameraModelType<Kb4>);

}  // namespace fca
