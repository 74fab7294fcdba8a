// SPDX-License-Identifier: BSD-3-Clause
// Pinhole with division distortion (Fitzgibbon 2001, "Simultaneous linear estimation of multiple view geometry and lens
// distortion"): a closed form in both directions.
//
//   p      = fx fy cx cy [px]  k
//   ray    = (x, y, 1 + k r^2),  (x, y) = ((u - cx) / fx, (v - cy) / fy),  r^2 = x^2 + y^2
//   pixel  = (fx s X + cx, fy s Y + cy),  s = 2 / (Z + sqrt(Z^2 - 4 k (X^2 + Y^2)))
//   domain : k < 0: all but the ray straight back;  k = 0: Z > 0;  k > 0: r < 1 / sqrt(k), beyond which the angle shrinks
//
// Negative k are barrel distortion, where it is eucm with alpha = 1/2 and beta = -4 k.
//
// Called: COLMAP DIVISION, SIMPLE_DIVISION (fx = fy); stella_vslam radial_division.
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>

#include <numbers>

namespace fca {

struct Division : internal::FocalLengthsFirst, internal::RayMap<Division> {
  static constexpr std::string_view kId = "division";
  static constexpr std::string_view kTitle = "Pinhole with division distortion";
  static constexpr std::string_view kContains = "pinhole";
  static constexpr std::array<std::string_view, 3> kAliases = {"radial-division", "simple-division", "fitzgibbon"};
  static constexpr std::array kParameters = {common_parameter::kFx, common_parameter::kFy, common_parameter::kCx,
                                             common_parameter::kCy, common_parameter::coefficient("k")};
  /// eucm describes nearly all of it.
  static constexpr bool kKeptOnly = true;

  static bool unproject(const double* p, const double* pixel, double* ray) {
    if (!internal::to_plane(p, pixel, ray[0], ray[1])) return false;
    const double bend = p[4] * (ray[0] * ray[0] + ray[1] * ray[1]);
    if (!(bend < 1.0)) return false;
    ray[2] = 1.0 + bend;
    return internal::normalise(ray);
  }

  static double max_angle(const double* p) {
    if (p[4] < 0.0) return std::numbers::pi;
    return std::atan2(1.0, 2.0 * std::sqrt(p[4]));
  }

  static constexpr int kStarts = 1;
  /// k r^2 = Z r / |(X, Y)| - 1, times |(X, Y)|.
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int /*start*/, double* p) {
    begin(centre, p);
    internal::LinearFit<1> fit;
    for (const Correspondence& s : samples) {
      const double across = std::hypot(s.ray[0], s.ray[1]);
      const double r = std::hypot((s.pixel[0] - p[2]) / p[0], (s.pixel[1] - p[3]) / p[1]);
      fit.add({across * r * r}, s.ray[2] * r - across, s.weight);
    }
    fit.solve(p + 4);
  }

  // In lib/models/division.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  friend struct internal::RayMap<Division>;
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    using std::sqrt;
    const T across2 = ray[0] * ray[0] + ray[1] * ray[1];
    const T radicand = ray[2] * ray[2] - T(4.0) * p[4] * across2;
    const bool is_ahead = internal::value_of(ray[2]) > 0.0;
    if (!(internal::value_of(radicand) > 0.0)) return false;
    if (!is_ahead && !(internal::value_of(p[4]) < 0.0 && internal::value_of(across2) > 0.0)) return false;
    const T root = sqrt(radicand);
    // Behind, the same without a difference of nearly equal numbers.
    const T scale = is_ahead ? T(T(2.0) / (ray[2] + root)) : T((ray[2] - root) / (T(2.0) * p[4] * across2));
    internal::to_pixel(p, T(scale * ray[0]), T(scale * ray[1]), pixel);
    return true;
  }
};

static_assert(CameraModelType<Division>);

}  // namespace fca
