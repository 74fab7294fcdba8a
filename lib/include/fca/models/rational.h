// SPDX-License-Identifier: BSD-3-Clause
// OpenCV's rational model with eight coefficients (Claus & Fitzgibbon 2005, "A rational function lens distortion model", cut
// down to its radial part; in the form of OpenCV's calib3d, CALIB_RATIONAL_MODEL).
//
//   p      = fx fy cx cy [px]  k1 k2 p1 p2 k3 k4 k5 k6   (the order of OpenCV's files)
//   (x, y) = ray / z,  t = x^2 + y^2
//   L      = N / D,  N = 1 + k1 t + k2 t^2 + k3 t^3,  D = 1 + k4 t + k5 t^2 + k6 t^3
//   m_x    = x L + 2 p1 x y + p2 (t + 2 x^2)
//   m_y    = y L + p1 (t + 2 y^2) + 2 p2 x y
//   pixel  = (fx m_x + cx, fy m_y + cy)
//   domain : z > 0 and r < r_max: before the first pole (D = 0), and on the disc on which the distortion's Jacobian is positive
//            definite (radial_tangential.h); without tangential terms, where the radius r L grows
//
// Where the domain comes from: A = d(r L)/dr = S / D^2 with S = N D + 2 t (N' D - N D'), a polynomial of degree 6 in t, so the
// disc's conditions A > 6 P r and A + 3 L > 16 P r become S > 6 P r D^2 and S + 3 N D > 16 P r D^2: degree 13 in r.
//
// With k4 = k5 = k6 = 0 this is radtan. OpenCV itself knows no domain: it images what lies beyond a pole mirrored or folded,
// and its undistortPoints iterates without converging there.
//
// Called: OpenCV 8-vectors; ROS rational_polynomial; Azure Kinect / K4A "Brown-Conrady" with k4..k6; Basalt pinhole-radtan8.
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>
#include <fca/models/radial_tangential.h>

#include <algorithm>

namespace fca {

namespace internal {

/// L = N / D, q = k1 k2 p1 p2 k3 k4 k5 k6.
struct RationalFactor {
  static constexpr std::size_t kCount = 8;
  static constexpr bool kPrism = false;

  template <class T>
  static T factor(const T* q, const T& t) {
    return (T(1.0) + t * (q[0] + t * (q[1] + t * q[4]))) / (T(1.0) + t * (q[5] + t * (q[6] + t * q[7])));
  }
  static void factor_and_derivative(const double* q, double t, double& value, double& derivative) {
    const double denominator = evaluate_polynomial(denominator_of(q), t);
    value = evaluate_polynomial(numerator_of(q), t) / denominator;
    const double numerator_derivative = q[0] + t * (2.0 * q[1] + t * 3.0 * q[4]);
    const double denominator_derivative = q[5] + t * (2.0 * q[6] + t * 3.0 * q[7]);
    derivative = (numerator_derivative - value * denominator_derivative) / denominator;
  }
  static bool defined(const double* q, double t) { return evaluate_polynomial(denominator_of(q), t) > 0.0; }

  static bool inside(const double* q, double r) {
    if (!positive_on(denominator_of(q), r * r)) return false;
    if (!has_tangential(q)) return positive_on(product(q, kRadial), r * r);
    return positive_on(with_tangential(q, kRadial, 6.0), r) && positive_on(with_tangential(q, kOtherAzimuths, 16.0), r);
  }

  static double max_radius(const double* q) {
    const double pole = before_pole(q);
    if (!has_tangential(q)) return std::sqrt(positive_until(product(q, kRadial), pole * pole));
    return positive_until(with_tangential(q, kOtherAzimuths, 16.0), positive_until(with_tangential(q, kRadial, 6.0), pole));
  }

 protected:
  static bool has_tangential(const double* q) { return q[2] != 0.0 || q[3] != 0.0; }
  /// A hair before the pole, where the radius is finite.
  static double before_pole(const double* q) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return (1.0 - 1e-12) * std::sqrt(positive_until(denominator_of(q), kInfinity));
  }
  static std::array<double, 4> numerator_of(const double* q) { return {1.0, q[0], q[1], q[4]}; }
  static std::array<double, 4> denominator_of(const double* q) { return {1.0, q[5], q[6], q[7]}; }

  /// How often N D counts in a condition next to 2 t (N' D - N D'): S, and S + 3 N D.
  static constexpr double kRadial = 1.0;
  static constexpr double kOtherAzimuths = 4.0;

  /// times N D + 2 t (N' D - N D') as a polynomial in t: the term n_i d_j t^(i + j) has the factor times + 2 (i - j).
  static std::array<double, 7> product(const double* q, double times) {
    const std::array<double, 4> n = numerator_of(q);
    const std::array<double, 4> d = denominator_of(q);
    std::array<double, 7> result{};
    for (std::size_t i = 0; i < n.size(); ++i) {
      for (std::size_t j = 0; j < d.size(); ++j) {
        result[i + j] += (times + 2.0 * (static_cast<double>(i) - static_cast<double>(j))) * n[i] * d[j];
      }
    }
    return result;
  }

  /// product - share P r D^2 as a polynomial in r.
  static std::array<double, 14> with_tangential(const double* q, double times, double share) {
    const std::array<double, 7> even = product(q, times);
    const std::array<double, 4> d = denominator_of(q);
    std::array<double, 14> result{};
    for (std::size_t i = 0; i < even.size(); ++i) result[2 * i] = even[i];
    const double tangential = share * length(q[2], q[3]);
    for (std::size_t i = 0; i < d.size(); ++i) {
      for (std::size_t j = 0; j < d.size(); ++j) result[2 * (i + j) + 1] -= tangential * d[i] * d[j];
    }
    return result;
  }
};

}  // namespace internal

struct Rational : internal::FocalLengthsFirst, internal::RayMap<Rational> {
  static constexpr std::string_view kId = "rational";
  static constexpr std::string_view kTitle = "OpenCV's rational model with 8 coefficients";
  static constexpr std::string_view kContains = "radtan";
  static constexpr std::array<std::string_view, 5> kAliases = {"rational-polynomial", "pinhole-rational", "pinhole-radtan8",
                                                               "radtan8", "opencv8"};
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
                                             common_parameter::coefficient("k6")};

  static constexpr bool kPerspective = true;
  static constexpr bool kHasPoles = true;

  static bool formula_and_derivatives(const double* p, const double* ray, double* pixel, double* du, double* dv) {
    const double x = ray[0] / ray[2];
    const double y = ray[1] / ray[2];
    const double t = x * x + y * y;
    const double denominator = 1.0 + t * (p[9] + t * (p[10] + t * p[11]));
    const double inverse = 1.0 / denominator;
    const double radial = (1.0 + t * (p[4] + t * (p[5] + t * p[8]))) * inverse;
    const double xy2 = 2.0 * x * y;
    const double x_term = t + 2.0 * x * x;
    const double y_term = t + 2.0 * y * y;
    const double mx = x * radial + p[6] * xy2 + p[7] * x_term;
    const double my = y * radial + p[6] * y_term + p[7] * xy2;
    pixel[0] = p[0] * mx + p[2];
    pixel[1] = p[1] * my + p[3];
    const double along_u = p[0] * x * inverse;
    const double along_v = p[1] * y * inverse;
    const std::array<double, 12> u = {mx,
                                      0.0,
                                      1.0,
                                      0.0,
                                      along_u * t,
                                      along_u * t * t,
                                      p[0] * xy2,
                                      p[0] * x_term,
                                      along_u * t * t * t,
                                      -along_u * radial * t,
                                      -along_u * radial * t * t,
                                      -along_u * radial * t * t * t};
    const std::array<double, 12> v = {0.0,
                                      my,
                                      0.0,
                                      1.0,
                                      along_v * t,
                                      along_v * t * t,
                                      p[1] * y_term,
                                      p[1] * xy2,
                                      along_v * t * t * t,
                                      -along_v * radial * t,
                                      -along_v * radial * t * t,
                                      -along_v * radial * t * t * t};
    internal::store(u, du);
    internal::store(v, dv);
    return ray[2] > 0.0 && denominator > 0.0;
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    double m[2];
    if (!internal::to_plane(p, pixel, m[0], m[1])) return false;
    if (!Distortion::undistort(p + 4, m, ray)) return false;
    ray[2] = 1.0;
    return internal::normalise(ray);
  }

  static double max_angle(const double* p) { return std::atan(Distortion::max_radius(p + 4)); }

  /// Multiplied by D, (pixel - c) D = f ((x, y) N + tangential terms D), all is linear in f, f k1 ..., c and the coefficients
  /// of D, if the D next to c and the tangential terms is that of the solution before; weighted by 1 / D^2 of that solution, it
  /// is the residual in pixels (Sanathanan & Koerner 1963). Poles among the samples can trap the fit: the other start has none,
  /// it is radtan's.
  static constexpr int kStarts = 2;
  static constexpr bool kStartsFindCentre = true;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int start, double* p) {
    begin(centre, p);
    std::fill_n(p + 4, internal::RationalFactor::kCount, 0.0);
    const double aspect = centre.focal[1] / centre.focal[0];
    constexpr int kRounds = 4;
    for (int round = 0; round < (start == 0 ? kRounds : 1); ++round) {
      // Unknown: fx, fx k1, fx k2, fx k3, fx p1, fx p2, cx, cy, k4, k5, k6; pixels in units of the source's focal length.
      internal::LinearFit<11> fit;
      for (const Correspondence& s : samples) {
        if (!(s.ray[2] > 0.0)) continue;
        const double x = s.ray[0] / s.ray[2];
        const double y = s.ray[1] / s.ray[2];
        const double t = x * x + y * y;
        const double t2 = t * t;
        const double t3 = t2 * t;
        constexpr double kSmallest = 0.01;
        const double d = round == 0 ? std::sqrt(1.0 + t) : std::max(kSmallest, 1.0 + p[9] * t + p[10] * t2 + p[11] * t3);
        const double weight = s.weight / (d * d);
        const double mx = (s.pixel[0] - centre.point[0]) / centre.focal[0];
        const double my = (s.pixel[1] - centre.point[1]) / centre.focal[1];
        // radtan's start: the last three unknowns stay 0, as nothing depends on them.
        const double ux = start == 0 ? mx : 0.0;
        const double uy = start == 0 ? my : 0.0;
        const double xy2 = 2.0 * x * y * d;
        fit.add({x, x * t, x * t2, x * t3, xy2, (t + 2.0 * x * x) * d, d, 0.0, -ux * t, -ux * t2, -ux * t3}, mx, weight);
        fit.add({y, y * t, y * t2, y * t3, (t + 2.0 * y * y) * d, xy2, 0.0, d, -uy * t, -uy * t2, -uy * t3}, my, weight);
      }
      double solution[11];
      fit.solve(solution);
      const auto& [f, fk1, fk2, fk3, fp1, fp2, cx, cy, k4, k5, k6] = solution;
      if (!(f > 0.0)) return;
      p[0] = f * centre.focal[0];
      p[1] = aspect * p[0];
      p[2] = centre.point[0] + cx * centre.focal[0];
      p[3] = centre.point[1] + cy * centre.focal[1];
      const double coefficients[] = {fk1 / f, fk2 / f, fp1 / f, fp2 / f, fk3 / f, k4, k5, k6};
      std::copy(std::begin(coefficients), std::end(coefficients), p + 4);
    }
  }

  // In lib/models/rational.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  friend struct internal::RayMap<Rational>;
  using Distortion = internal::TangentialOver<internal::RationalFactor>;

  /// No value beyond a pole, either, without the domain: a fit has no way back from there.
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    if (!(internal::value_of(ray[2]) > 0.0)) return false;
    T m[2];
    if (!Distortion::distort<kWithinDomain>(p + 4, T(ray[0] / ray[2]), T(ray[1] / ray[2]), m)) return false;
    internal::to_pixel(p, m[0], m[1], pixel);
    return true;
  }
};

static_assert(CameraModelType<Rational>);

}  // namespace fca
