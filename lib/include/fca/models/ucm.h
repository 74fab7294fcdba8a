// SPDX-License-Identifier: BSD-3-Clause
// Unified Camera Model (Geyer & Daniilidis 2000, Mei & Rives 2007; in the form of Usenko, Demmel, Cremers 2018, sec. III-A).
//
//   p      = fx fy cx cy [px]  alpha in [0, 1]
//   d      = |(x, y, z)|
//   m      = (x, y) / (alpha d + (1 - alpha) z)
//   pixel  = (fx m_x + cx, fy m_y + cy)
//   domain : EUCM's with beta = 1; the largest angle is acos(-w)
//
// Differs from the paper (Lee, eq. 6): no xi = alpha / (1 - alpha), which breaks at alpha = 1 (ERRATA 7).
// Called: Kalibr omni-none with xi = alpha / (1 - alpha) and focal lengths f / (1 - alpha); or eucm with beta = 1.
#pragma once

#include <fca/models/eucm.h>

namespace fca {

struct Ucm : internal::FocalLengthsFirst, internal::RayMap<Ucm> {
  static constexpr std::string_view kId = "ucm";
  static constexpr std::string_view kTitle = "Unified Camera Model";
  static constexpr bool kRound = true;
  static constexpr std::string_view kContains = "pinhole";
  static constexpr std::array<std::string_view, 2> kAliases = {"unified", "unified-camera-model"};
  static constexpr std::array kParameters = {common_parameter::kFx, common_parameter::kFy, common_parameter::kCx,
                                             common_parameter::kCy, Parameter{"alpha", "", 0.0, 1.0, ParameterGroup::kLens}};

  static bool formula_and_derivatives(const double* p, const double* ray, double* pixel, double* du, double* dv) {
    const double r2 = ray[0] * ray[0] + ray[1] * ray[1];
    const double d = std::sqrt(r2 + ray[2] * ray[2]);
    const double denominator = internal::unified_sum(p[4], d, 1.0 - p[4], ray[2], r2);
    internal::radial_derivatives<1>(p, ray, denominator, {d - ray[2]}, pixel, du, dv);
    return denominator > 0.0;
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    if (!internal::to_plane(p, pixel, ray[0], ray[1])) return false;
    const double r2 = ray[0] * ray[0] + ray[1] * ray[1];
    return internal::UnifiedPlane::lift(p[4], 1.0, r2, ray[2]) && internal::normalise(ray);
  }

  static double max_angle(const double* p) { return internal::UnifiedPlane::max_angle(p[4], 1.0); }

  static constexpr int kStarts = 1;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int /*start*/, double* p) {
    begin(centre, p);
    p[4] = internal::UnifiedPlane::linear_alpha(samples, p, 1.0);
  }

  // In lib/models/ucm.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  friend struct internal::RayMap<Ucm>;
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    T m[2];
    if (!internal::UnifiedPlane::project<kWithinDomain>(p[4], T(1.0), ray, m)) return false;
    internal::to_pixel(p, m[0], m[1], pixel);
    return true;
  }
};

static_assert(CameraModelType<Ucm>);

}  // namespace fca
