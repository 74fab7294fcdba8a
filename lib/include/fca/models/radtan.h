// SPDX-License-Identifier: BSD-3-Clause
// Pinhole with radial-tangential distortion (Brown 1971; in the form of OpenCV's calib3d).
//
//   p      = fx fy cx cy [px]  k1 k2 p1 p2 k3
//   (x, y) = ray / z,  r^2 = x^2 + y^2,  L = 1 + k1 r^2 + k2 r^4 + k3 r^6
//   m_x    = x L + 2 p1 x y + p2 (r^2 + 2 x^2)
//   m_y    = y L + p1 (r^2 + 2 y^2) + 2 p2 x y
//   pixel  = (fx m_x + cx, fy m_y + cy)
//   domain : z > 0 and r < r_max, the disc on which the distortion's Jacobian is positive definite (radial_tangential.h)
//
// Parameter order is that of OpenCV's files (k1 k2 p1 p2 k3), not the paper's (ERRATA 10). With four coefficients k3 is 0.
//
// Called: Kalibr pinhole-radtan (no k3); ORB-SLAM3 PinHole; OpenCV 4- and 5-vectors; ROS plumb_bob; "Brown-Conrady".
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>
#include <fca/models/radial_tangential.h>

#include <algorithm>

namespace fca {

struct Radtan : internal::FocalLengthsFirst, internal::RayMap<Radtan> {
  static constexpr std::string_view kId = "radtan";
  static constexpr std::string_view kTitle = "Pinhole with radial-tangential distortion";
  static constexpr std::string_view kContains = "pinhole";
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

  static constexpr bool kPerspective = true;
  static constexpr std::string_view kBendsBack = "k3";

  static bool formula_and_derivatives(const double* p, const double* ray, double* pixel, double* du, double* dv) {
    const double x = ray[0] / ray[2];
    const double y = ray[1] / ray[2];
    const double r2 = x * x + y * y;
    const double radial = 1.0 + r2 * (p[4] + r2 * (p[5] + r2 * p[8]));
    const double xy2 = 2.0 * x * y;
    const double x_term = r2 + 2.0 * x * x;
    const double y_term = r2 + 2.0 * y * y;
    const double mx = x * radial + p[6] * xy2 + p[7] * x_term;
    const double my = y * radial + p[6] * y_term + p[7] * xy2;
    pixel[0] = p[0] * mx + p[2];
    pixel[1] = p[1] * my + p[3];
    const double u1 = p[0] * x * r2;
    const double v1 = p[1] * y * r2;
    const std::array<double, 9> u = {mx, 0.0, 1.0, 0.0, u1, u1 * r2, p[0] * xy2, p[0] * x_term, u1 * r2 * r2};
    const std::array<double, 9> v = {0.0, my, 0.0, 1.0, v1, v1 * r2, p[1] * y_term, p[1] * xy2, v1 * r2 * r2};
    internal::store(u, du);
    internal::store(v, dv);
    return ray[2] > 0.0;
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    double m[2];
    if (!internal::to_plane(p, pixel, m[0], m[1])) return false;
    if (!internal::RadialTangential::undistort(p + 4, m, ray)) return false;
    ray[2] = 1.0;
    return internal::normalise(ray);
  }

  static double max_angle(const double* p) { return std::atan(internal::RadialTangential::max_radius(p + 4)); }

  /// With f, f k1, f k2, f p1, f p2, f k3.
  static constexpr std::size_t kTerms = 6;
  static bool terms(const double* ray, double* along_u, double* along_v) {
    if (!(ray[2] > 0.0)) return false;
    const double x = ray[0] / ray[2];
    const double y = ray[1] / ray[2];
    const double r2 = x * x + y * y;
    const std::array<double, kTerms> u = {x, x * r2, x * r2 * r2, 2.0 * x * y, r2 + 2.0 * x * x, x * r2 * r2 * r2};
    const std::array<double, kTerms> v = {y, y * r2, y * r2 * r2, r2 + 2.0 * y * y, 2.0 * x * y, y * r2 * r2 * r2};
    for (std::size_t i = 0; i < kTerms; ++i) {
      along_u[i] = u[i];
      along_v[i] = v[i];
    }
    return true;
  }
  static void from_terms(const double* c, double aspect, const std::array<double, 2>& point, double* p) {
    begin({{c[0], aspect * c[0]}, point}, p);
    for (std::size_t i = 1; i < kTerms; ++i) p[3 + i] = c[i] / c[0];
  }

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

  // In lib/models/radtan.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  friend struct internal::RayMap<Radtan>;
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
