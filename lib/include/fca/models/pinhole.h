// SPDX-License-Identifier: BSD-3-Clause
// Pinhole: a lens without distortion.
//
//   p      = fx fy cx cy                                  [px]
//   pixel  = (fx x / z + cx, fy y / z + cy)
//   domain : z > 0
//
// Called: Kalibr pinhole-none; ORB-SLAM3 PinHole without k1, Rectified; OpenCV camera_matrix with zero distortion.
#pragma once

#include <fca/models/model_traits.h>

#include <numbers>

namespace fca {

struct Pinhole : internal::FocalLengthsFirst {
  static constexpr std::string_view kId = "pinhole";
  static constexpr std::string_view kTitle = "Pinhole";
  static constexpr bool kRound = true;
  static constexpr std::array<std::string_view, 4> kAliases = {"none", "pinhole-none", "rectified", "perspective"};
  static constexpr std::array kParameters = {common_parameter::kFx, common_parameter::kFy, common_parameter::kCx,
                                             common_parameter::kCy};

  template <class T>
  static bool project(const T* p, const T* ray, T* pixel) {
    if (!(internal::value_of(ray[2]) > 0.0)) return false;
    internal::to_pixel(p, T(ray[0] / ray[2]), T(ray[1] / ray[2]), pixel);
    return true;
  }

  template <class T>
  static bool formula(const T* p, const T* ray, T* pixel) {
    return project(p, ray, pixel);
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    if (!internal::to_plane(p, pixel, ray[0], ray[1])) return false;
    ray[2] = 1.0;
    return internal::normalise(ray);
  }

  static constexpr bool kPerspective = true;
  static double max_angle(const double* /*p*/) { return 0.5 * std::numbers::pi; }
  static constexpr std::size_t kTerms = 1;
  static bool terms(const double* ray, double* along_u, double* along_v) {
    if (!(ray[2] > 0.0)) return false;
    along_u[0] = ray[0] / ray[2];
    along_v[0] = ray[1] / ray[2];
    return true;
  }
  static void from_terms(const double* c, double aspect, const std::array<double, 2>& point, double* p) {
    begin({{c[0], aspect * c[0]}, point}, p);
  }

  static constexpr int kStarts = 1;
  static void initialise(std::span<const Correspondence> /*samples*/, const LensCentre& centre, int /*start*/, double* p) {
    begin(centre, p);
  }
  // In lib/models/pinhole.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
};

static_assert(CameraModelType<Pinhole>);

}  // namespace fca
