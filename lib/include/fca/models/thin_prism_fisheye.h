// SPDX-License-Identifier: BSD-3-Clause
// Kannala-Brandt with tangential distortion and a thin prism, all of the undistorted angle (COLMAP's THIN_PRISM_FISHEYE,
// colmap@5d968cf, sensor/models.h).
//
//   p      = fx fy cx cy [px]  k1 k2 p1 p2 k3 k4 sx1 sy1   (the order of COLMAP's files)
//   (x, y) = theta (X, Y) / |(X, Y)|,  theta = atan2(|(X, Y)|, Z),  r = theta
//   m_x    = x (1 + k1 r^2 + k2 r^4 + k3 r^6 + k4 r^8) + 2 p1 x y + p2 (r^2 + 2 x^2) + sx1 r^2
//   m_y    = y (...)                                  + p1 (r^2 + 2 y^2) + 2 p2 x y + sy1 r^2
//   pixel  = (fx m_x + cx, fy m_y + cy)
//   domain : theta < pi and on the disc on which the Jacobian's symmetric part is positive definite (radial_tangential.h)
//
// Without p1, p2, sx1, sy1 this is kb4. fisheye624 is another model: its further terms act on the distorted point.
#pragma once

#include <fca/models/kb4.h>
#include <fca/models/model_traits.h>
#include <fca/models/radial_tangential.h>

#include <algorithm>
#include <numbers>

namespace fca {

namespace internal {

/// L = 1 + k1 r^2 + k2 r^4 + k3 r^6 + k4 r^8 with a thin prism, q = k1 k2 p1 p2 k3 k4 sx1 sy1.
struct FisheyePrismFactor {
  static constexpr std::size_t kCount = 8;
  static constexpr bool kPrism = true;

  template <class T>
  static T factor(const T* q, const T& r2) {
    return T(1.0) + r2 * (q[0] + r2 * (q[1] + r2 * (q[4] + r2 * q[5])));
  }
  static void factor_and_derivative(const double* q, double r2, double& value, double& derivative) {
    value = factor(q, r2);
    derivative = q[0] + r2 * (2.0 * q[1] + r2 * (3.0 * q[4] + r2 * 4.0 * q[5]));
  }
  static bool defined(const double* /*q*/, double /*r2*/) { return true; }

  static bool inside(const double* q, double r) {
    return positive_on(condition(q, 0.0, 2.0, 1.0), r) && positive_on(condition(q, 1.0, 6.0, 1.0), r) &&
           positive_on(condition(q, 1.0, 16.0, 4.0), r);
  }
  static double max_radius(const double* q) {
    double radius = std::numbers::pi;
    radius = positive_until(condition(q, 1.0, 6.0, 1.0), radius);
    radius = positive_until(condition(q, 1.0, 16.0, 4.0), radius);
    return positive_until(condition(q, 0.0, 2.0, 1.0), radius);
  }

  static double longest(const double* q, double r2) { return r2 * length(q[6], q[7]); }
  template <class T>
  static void add(const T* q, const T& r2, T* m) {
    m[0] += r2 * q[6];
    m[1] += r2 * q[7];
  }
  static std::array<double, 2> derivatives(const double* q, double /*r2*/) { return {q[6], q[7]}; }

 private:
  /// How often d(r L)/dr counts next to L, and P: A - 6 P r, A + 3 L - 16 P r, L - 2 P r. The prism takes 2 |(sx1, sy1)| r from
  /// each of A and L.
  static std::array<double, 9> condition(const double* q, double of_derivative, double tangential, double count) {
    const double k[5] = {1.0, q[0], q[1], q[4], q[5]};
    std::array<double, 9> result{};
    for (std::size_t i = 0; i < 5; ++i) result[2 * i] = (count + of_derivative * 2.0 * static_cast<double>(i)) * k[i];
    result[1] = -tangential * length(q[2], q[3]) - 2.0 * count * length(q[6], q[7]);
    return result;
  }
};

}  // namespace internal

struct ThinPrismFisheye : internal::FocalLengthsFirst, internal::RayMap<ThinPrismFisheye> {
  static constexpr std::string_view kId = "thin-prism-fisheye";
  static constexpr std::string_view kTitle = "Kannala-Brandt with tangential distortion and thin prism";
  static constexpr std::string_view kContains = "kb4";
  static constexpr std::array<std::string_view, 1> kAliases = {"kb4-thin-prism"};
  static constexpr std::array kParameters = {common_parameter::kFx,
                                             common_parameter::kFy,
                                             common_parameter::kCx,
                                             common_parameter::kCy,
                                             common_parameter::coefficient("k1"),
                                             common_parameter::coefficient("k2"),
                                             common_parameter::coefficient("p1"),
                                             common_parameter::coefficient("p2"),
                                             common_parameter::coefficient("k3"),
                                             common_parameter::coefficient("k4"),
                                             common_parameter::coefficient("sx1"),
                                             common_parameter::coefficient("sy1")};
  static constexpr bool kKeptOnly = true;

  static bool unproject(const double* p, const double* pixel, double* ray) {
    double m[2];
    double xy[2];
    if (!internal::to_plane(p, pixel, m[0], m[1]) || !Distortion::undistort(p + 4, m, xy)) return false;
    const double theta = internal::length(xy[0], xy[1]);
    if (!(theta < std::numbers::pi)) return false;
    internal::ray_at_angle(theta, xy[0], xy[1], theta, ray);
    return true;
  }

  static double max_angle(const double* p) { return Distortion::max_radius(p + 4); }

  static constexpr int kStarts = 1;
  /// Kannala-Brandt's.
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int start, double* p) {
    double kb4[kParameterCount<Kb4>];
    Kb4::initialise(samples, centre, start, kb4);
    const std::array<double, kParameters.size()> values = {kb4[0], kb4[1], kb4[2], kb4[3], kb4[4], kb4[5],
                                                           0.0,    0.0,    kb4[6], kb4[7], 0.0,    0.0};
    std::ranges::copy(values, p);
  }

  // In lib/models/thin_prism_fisheye.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  friend struct internal::RayMap<ThinPrismFisheye>;
  using Distortion = internal::TangentialOver<internal::FisheyePrismFactor>;

  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    T plane[2];
    T m[2];
    if (!internal::equidistant(ray, plane)) return false;
    const double angle = internal::length(internal::value_of(plane[0]), internal::value_of(plane[1]));
    if (kWithinDomain && !(angle < std::numbers::pi)) return false;
    if (!Distortion::distort<kWithinDomain>(p + 4, plane[0], plane[1], m)) return false;
    internal::to_pixel(p, m[0], m[1], pixel);
    return true;
  }
};

static_assert(CameraModelType<ThinPrismFisheye>);

}  // namespace fca
