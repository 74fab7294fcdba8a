// SPDX-License-Identifier: BSD-3-Clause
// OpenCV's model with all of its 14 coefficients: the rational model, four thin prism terms (Weng, Cohen & Herniou 1992) and an
// image plane that is tilted against the lens (Louhichi et al. 2007, "A model for Scheimpflug cameras"); in the form of
// OpenCV's calib3d, CALIB_RATIONAL_MODEL | CALIB_THIN_PRISM_MODEL | CALIB_TILTED_MODEL. Without the tilt these are its 12.
//
//   p      = fx fy cx cy [px]  k1 k2 p1 p2 k3 k4 k5 k6  s1 s2 s3 s4  tau_x tau_y [rad]   (the order of OpenCV's files)
//   (x, y) = ray / z,  t = x^2 + y^2,  L as in rational.h
//   m_x    = x L + 2 p1 x y + p2 (t + 2 x^2) + s1 t + s2 t^2
//   m_y    = y L + p1 (t + 2 y^2) + 2 p2 x y + s3 t + s4 t^2
//   (X, Y, W) = (c_x m_x,  c_y m_y - s_x s_y m_x,  c_x c_y + s_y m_x - s_x c_y m_y),  c, s = cos, sin of tau
//   pixel  = (fx X / W + cx, fy Y / W + cy)
//   domain : z > 0 and r < r_max: rational's disc with the thin prism (radial_tangential.h), and W > 0 all over it
//
// The tilt is OpenCV's product [R33 0 -R13; 0 R33 -R23; 0 0 1] Ry(tau_y) Rx(tau_x), multiplied out. It keeps the principal
// point.
//
// A fit holds the prism and the tilt: from rays and pixels alone they are hardly told from the tangential terms.
//
// Called: OpenCV 12- and 14-vectors; the factory calibration of OAK cameras (14); ncore's "opencv-pinhole" (12).
#pragma once

#include <fca/models/rational.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace fca {

namespace internal {

/// RationalFactor with thin prism terms: q = k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4.
struct PrismFactor : RationalFactor, ThinPrism<8> {
  static constexpr std::size_t kCount = 12;
  static constexpr bool kPrism = true;

  static bool inside(const double* q, double r) {
    if (!has_prism(q)) return RationalFactor::inside(q, r);
    return positive_on(denominator_of(q), r * r) && positive_on(with_prism(q, kRadial, 6.0, 1.0), r) &&
           positive_on(with_prism(q, kOtherAzimuths, 16.0, 4.0), r) && positive_on(across(q), r);
  }

  static double max_radius(const double* q) {
    if (!has_prism(q)) return RationalFactor::max_radius(q);
    const double other = positive_until(with_prism(q, kOtherAzimuths, 16.0, 4.0),
                                        positive_until(with_prism(q, kRadial, 6.0, 1.0), before_pole(q)));
    return positive_until(across(q), other);
  }

  /// W > 0 as a polynomial in r times D: the distorted point is at most r N / D + 3 P r^2 and the prism's length from the
  /// centre.
  static std::array<double, 11> ahead_of_plane(const double* q, double at_centre, double slope) {
    const std::array<double, 4> n = numerator_of(q);
    const std::array<double, 4> d = denominator_of(q);
    const std::array<double, 2> moved = {3.0 * length(q[2], q[3]) + linear(q), square(q)};
    std::array<double, 11> result{};
    for (std::size_t i = 0; i < n.size(); ++i) {
      result[2 * i] += at_centre * d[i];
      result[2 * i + 1] -= slope * n[i];
      result[2 * i + 2] -= slope * moved[0] * d[i];
      result[2 * i + 4] -= slope * moved[1] * d[i];
    }
    return result;
  }

 private:
  static bool has_prism(const double* q) {
    return std::any_of(q + RationalFactor::kCount, q + kCount, [](double s) { return s != 0.0; });
  }

  /// L - 2 P r without what the prism takes of it, times D. Without a prism that is positive where A - 6 P r is.
  static std::array<double, 10> across(const double* q) {
    const std::array<double, 4> n = numerator_of(q);
    const std::array<double, 4> d = denominator_of(q);
    const double taken = 2.0 * (length(q[2], q[3]) + linear(q));
    std::array<double, 10> result{};
    for (std::size_t i = 0; i < n.size(); ++i) {
      result[2 * i] += n[i];
      result[2 * i + 1] -= taken * d[i];
      result[2 * i + 3] -= 4.0 * square(q) * d[i];
    }
    return result;
  }

  /// The prism takes at most its gradient's length times r, (2 (s1, s3) + 4 (s2, s4) r^2) r, from the Jacobian's eigenvalues:
  /// `share` of it, times D^2, from rational's condition.
  static std::array<double, 16> with_prism(const double* q, double times, double tangential, double share) {
    const std::array<double, 14> without = with_tangential(q, times, tangential);
    const std::array<double, 4> d = denominator_of(q);
    std::array<double, 16> result{};
    std::copy(without.begin(), without.end(), result.begin());
    for (std::size_t i = 0; i < d.size(); ++i) {
      for (std::size_t j = 0; j < d.size(); ++j) {
        result[2 * (i + j) + 1] -= share * 2.0 * linear(q) * d[i] * d[j];
        result[2 * (i + j) + 3] -= share * 4.0 * square(q) * d[i] * d[j];
      }
    }
    return result;
  }
};

/// The map of a plane to one that is tilted against it.
template <class T>
struct Tilt {
  T sx, cx, sy, cy;

  Tilt(const T& tau_x, const T& tau_y) : sx(sine(tau_x)), cx(cosine(tau_x)), sy(sine(tau_y)), cy(cosine(tau_y)) {}

  /// False behind the tilted plane.
  bool apply(T* m) const {
    const T w = cx * cy + sy * m[0] - sx * cy * m[1];
    if (!(value_of(w) > 0.0)) return false;
    const T x = cx * m[0] / w;
    m[1] = (cy * m[1] - sx * sy * m[0]) / w;
    m[0] = x;
    return true;
  }
  bool undo(T* m) const {
    const T scale = cx * cy / (T(1.0) - sy * cx * m[0] + sx * m[1]);  // W
    if (!(value_of(scale) > 0.0) || !std::isfinite(value_of(scale))) return false;
    const T x = m[0] * scale / cx;
    m[1] = (m[1] * scale + sx * sy * x) / cy;
    m[0] = x;
    return true;
  }

 private:
  static T sine(const T& x) {
    using std::sin;
    return sin(x);
  }
  static T cosine(const T& x) {
    using std::cos;
    return cos(x);
  }
};

}  // namespace internal

struct Opencv14 : internal::FocalLengthsFirst, internal::RayMap<Opencv14> {
  static constexpr std::string_view kId = "opencv14";
  static constexpr std::string_view kTitle = "OpenCV's model with 14 coefficients (thin prism, tilt)";
  static constexpr std::string_view kContains = "rational";
  static constexpr std::array<std::string_view, 4> kAliases = {"opencv12", "thin-prism", "rational-thin-prism", "tilted"};
  /// Far more than any sensor is tilted.
  static constexpr double kLargestTilt = 1.0;  // rad
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
                                             common_parameter::coefficient("k5"),
                                             common_parameter::coefficient("k6"),
                                             common_parameter::coefficient("s1"),
                                             common_parameter::coefficient("s2"),
                                             common_parameter::coefficient("s3"),
                                             common_parameter::coefficient("s4"),
                                             Parameter{"tau_x", "rad", -kLargestTilt, kLargestTilt, ParameterGroup::kLens},
                                             Parameter{"tau_y", "rad", -kLargestTilt, kLargestTilt, ParameterGroup::kLens}};
  static constexpr std::array<std::string_view, 6> kHeldInFits = {"s1", "s2", "s3", "s4", "tau_x", "tau_y"};
  static constexpr bool kKeptOnly = true;

  static constexpr bool kPerspective = true;
  static constexpr bool kHasPoles = true;

  static bool is_tilted(const double* p) { return p[16] != 0.0 || p[17] != 0.0; }

  static std::array<double, 2> central_focal_lengths(const double* p) {
    return {p[0] / std::cos(p[17]), p[1] / std::cos(p[16])};
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    double m[2];
    if (!internal::to_plane(p, pixel, m[0], m[1])) return false;
    if (is_tilted(p) && !internal::Tilt<double>(p[16], p[17]).undo(m)) return false;
    if (!Distortion::undistort(p + 4, m, ray)) return false;
    // A point that is beyond the tilted plane's horizon on the way there is none of the domain.
    if (is_tilted(p) && !is_ahead_of_plane(p, internal::length(ray[0], ray[1]))) return false;
    ray[2] = 1.0;
    return internal::normalise(ray);
  }

  static double max_angle(const double* p) {
    const double radius = Distortion::max_radius(p + 4);
    if (!is_tilted(p)) return std::atan(radius);
    const auto [at_centre, slope] = plane_of(p);
    return std::atan(positive_until(internal::PrismFactor::ahead_of_plane(p + 4, at_centre, slope), radius));
  }

  static constexpr int kStarts = Rational::kStarts;
  static constexpr bool kStartsFindCentre = true;
  /// Rational's, without prism and tilt.
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int start, double* p) {
    Rational::initialise(samples, centre, start, p);
    std::fill_n(p + Rational::kParameters.size(), kParameters.size() - Rational::kParameters.size(), 0.0);
  }

  // In lib/models/opencv14.
  /// Without its tilt: that of the plane.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  /// With it.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::TiltedPolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  friend struct internal::RayMap<Opencv14>;
  using Distortion = internal::TangentialOver<internal::PrismFactor>;

  /// W at the centre, and how much it falls with the distance of a distorted point from there, at most.
  static std::array<double, 2> plane_of(const double* p) {
    const internal::Tilt<double> tilt(p[16], p[17]);
    return {tilt.cx * tilt.cy, internal::length(tilt.sy, tilt.sx * tilt.cy)};
  }
  static bool is_ahead_of_plane(const double* p, double r) {
    const auto [at_centre, slope] = plane_of(p);
    return positive_on(internal::PrismFactor::ahead_of_plane(p + 4, at_centre, slope), r);
  }

  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    if (!(internal::value_of(ray[2]) > 0.0)) return false;
    T m[2];
    const T x = ray[0] / ray[2];
    const T y = ray[1] / ray[2];
    if (!Distortion::distort<kWithinDomain>(p + 4, x, y, m)) return false;
    double values[kParameters.size()];
    std::transform(p, p + kParameters.size(), values, [](const T& value) { return internal::value_of(value); });
    // A fit may vary the tilt at 0, so derivatives always pass through it.
    if (!std::is_same_v<T, double> || is_tilted(values)) {
      const double radius = internal::length(internal::value_of(x), internal::value_of(y));
      if (kWithinDomain && is_tilted(values) && !is_ahead_of_plane(values, radius)) return false;
      if (!internal::Tilt<T>(p[16], p[17]).apply(m)) return false;
    }
    internal::to_pixel(p, m[0], m[1], pixel);
    return true;
  }
};

static_assert(CameraModelType<Opencv14>);

}  // namespace fca
