// SPDX-License-Identifier: BSD-3-Clause
// Field-of-view model (Devernay & Faugeras 2001, "Straight lines have to be straight", eq. 13).
//
//   p      = fx fy cx cy [px]  w in (0, pi): the field of view of the ideal fisheye lens [rad]
//   r      = |(x, y)|,  r_d = atan2(2 r tan(w / 2), z) / w
//   pixel  = (fx r_d x / r + cx, fy r_d y / r + cy)
//   domain : angle < pi (the formula, written with atan2, goes on smoothly beyond 90 degrees)
//
// Called: Kalibr pinhole-fov (valid there for w in [0.5, 1.5] and z > 0); PTAM/DSO ATAN, "FOV".
#pragma once

#include <fca/models/model_traits.h>

#include <algorithm>
#include <numbers>

namespace fca {

struct Fov : internal::FocalLengthsFirst {
  static constexpr std::string_view kId = "fov";
  static constexpr std::string_view kTitle = "Field of view (FOV, ATAN)";
  static constexpr bool kRound = true;
  static constexpr std::array<std::string_view, 2> kAliases = {"pinhole-fov", "atan"};
  static constexpr std::array kParameters = {common_parameter::kFx, common_parameter::kFy, common_parameter::kCx,
                                             common_parameter::kCy,
                                             Parameter{"w", "rad", 0.0, std::numbers::pi, ParameterGroup::kLens, true}};

  template <class T>
  static bool project(const T* p, const T* ray, T* pixel) {
    using std::atan2;
    using std::sqrt;
    using std::tan;
    if (!valid(internal::value_of(p[4]))) return false;
    const T tangent = T(2.0) * tan(p[4] * T(0.5));
    const T r2 = ray[0] * ray[0] + ray[1] * ray[1];
    if (!(internal::value_of(r2) > 0.0)) {  // on the axis, where r has no derivative
      if (!(internal::value_of(ray[2]) > 0.0)) return false;
      const T scale = tangent / (p[4] * ray[2]);
      internal::to_pixel(p, T(scale * ray[0]), T(scale * ray[1]), pixel);
      return true;
    }
    const T r = sqrt(r2);
    const T scale = atan2(tangent * r, ray[2]) / (p[4] * r);
    internal::to_pixel(p, T(scale * ray[0]), T(scale * ray[1]), pixel);
    return true;
  }

  template <class T>
  static bool formula(const T* p, const T* ray, T* pixel) {
    return project(p, ray, pixel);
  }

  static bool formula_and_derivatives(const double* p, const double* ray, double* pixel, double* du, double* dv) {
    const double w = p[4];
    const double r = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1]);
    if (!valid(w) || !(r > 0.0 || ray[2] > 0.0)) return false;
    const double half = std::tan(0.5 * w);
    const double tangent = 2.0 * half;
    // With a = atan2(tangent r, z): (x, y) / D for D = w r / a, and dD/dw = D (1 / w - da/dw / a).
    // On the axis a / r is tangent / z.
    const double tangent_by_w = 1.0 + half * half;
    const double length2 = tangent * r * tangent * r + ray[2] * ray[2];
    const double bent_per_r = r > 0.0 ? std::atan2(tangent * r, ray[2]) / r : tangent / ray[2];
    const double denominator = w / bent_per_r;
    const double by_w = denominator * (1.0 / w - tangent_by_w * ray[2] / (length2 * bent_per_r));
    internal::radial_derivatives<1>(p, ray, denominator, {by_w}, pixel, du, dv);
    return true;
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    double mx = 0.0;
    double my = 0.0;
    if (!valid(p[4]) || !internal::to_plane(p, pixel, mx, my)) return false;
    const double radius = std::sqrt(mx * mx + my * my);
    const double bent = radius * p[4];
    if (!(bent < std::numbers::pi)) return false;
    internal::ray_at_angle(std::atan2(std::sin(bent), std::cos(bent) * 2.0 * std::tan(0.5 * p[4])), mx, my, radius, ray);
    return true;
  }

  static double max_angle(const double* /*p*/) { return std::numbers::pi; }

  /// Given w, one term. Far from any fov lens the residual has several minima along w.
  static constexpr std::array kShapes = {0.1, 0.3, 0.5, 0.7, 0.9, 1.1,  1.3,  1.5,  1.7,
                                         1.9, 2.1, 2.3, 2.5, 2.7, 2.85, 2.95, 3.05, 3.12};
  static constexpr std::size_t kTerms = 1;
  static bool terms(double w, const double* ray, double* along_u, double* along_v) {
    const double r = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1]);
    if (!valid(w) || !(r > 0.0 || ray[2] > 0.0)) return false;
    const double tangent = 2.0 * std::tan(0.5 * w);
    const double scale = (r > 0.0 ? std::atan2(tangent * r, ray[2]) / r : tangent / ray[2]) / w;
    along_u[0] = scale * ray[0];
    along_v[0] = scale * ray[1];
    return true;
  }
  static void from_terms(double w, const double* c, double aspect, const std::array<double, 2>& point, double* p) {
    begin({{c[0], aspect * c[0]}, point}, p);
    p[4] = w;
  }

  static constexpr int kStarts = 3;
  static void initialise(std::span<const Correspondence> /*samples*/, const LensCentre& centre, int start, double* p) {
    const double w = 0.5 + start;
    begin(centre, p, 1.0 / central_factor(w));
    p[4] = w;
  }

  static std::array<double, 2> central_focal_lengths(const double* p) {
    return {p[0] * central_factor(p[4]), p[1] * central_factor(p[4])};
  }

  // In lib/models/fov.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  /// r_d per angle at the centre.
  static double central_factor(double w) { return 2.0 * std::tan(0.5 * w) / w; }

  static bool valid(double w) { return w > 0.0 && w < std::numbers::pi; }
};

static_assert(CameraModelType<Fov>);

}  // namespace fca
