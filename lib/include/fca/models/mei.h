// SPDX-License-Identifier: BSD-3-Clause
// Mei: the unified model with radial-tangential distortion (Mei & Rives 2007).
//
//   p      = fx fy cx cy [px]  xi >= 0  k1 k2 p1 p2
//   (x, y) = ray / (z + xi |ray|), then radial-tangential distortion (radial_tangential.h, k3 = 0)
//   pixel  = (fx m_x + cx, fy m_y + cy)
//   domain : z > -|ray| min(xi, 1 / xi), and the distortion's disc
//
// Without distortion this is UCM with alpha = xi / (1 + xi) and focal lengths f / (1 + xi).
// Called: Kalibr omni-radtan (order xi fu fv pu pv); cv::omnidir; camodocal and VINS MEI. "Omni" in some forks.
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>
#include <fca/models/radial_tangential.h>

#include <algorithm>

namespace fca {

struct Mei : internal::FocalLengthsFirst, internal::RayMap<Mei> {
  static constexpr std::string_view kId = "mei";
  static constexpr std::string_view kTitle = "Mei (unified model with radial-tangential distortion)";
  static constexpr std::string_view kContains = "ucm";
  static constexpr std::array<std::string_view, 4> kAliases = {"omni", "omni-radtan", "omni-none", "omnidir"};
  /// A parabola mirror (ucm with alpha = 1) is the limit xi -> infinity: with focal lengths f at the centre, a camera with
  /// this xi is less than f / xi away from it. Programs find the height of a pixel's ray as a difference of two numbers as
  /// large as xi, which rounding leaves at 1e-16 xi: at 1e8 both are about 1e-8 radians, some 1e-6 px.
  static constexpr double kFurthestXi = 1e8;
  static constexpr std::array kParameters = {
      common_parameter::kFx,
      common_parameter::kFy,
      common_parameter::kCx,
      common_parameter::kCy,
      Parameter{"xi", "", 0.0, common_parameter::kInfinity, ParameterGroup::kLens, false, kFurthestXi, {0.0, 3.0}},
      common_parameter::coefficient("k1"),
      common_parameter::coefficient("k2"),
      common_parameter::coefficient("p1"),
      common_parameter::coefficient("p2")};

  static bool formula_and_derivatives(const double* p, const double* ray, double* pixel, double* du, double* dv) {
    const double r2 = ray[0] * ray[0] + ray[1] * ray[1];
    const double denominator = internal::unified_sum(p[4], 1.0, 1.0, ray[2], r2);
    const double x = ray[0] / denominator;
    const double y = ray[1] / denominator;
    const double t = x * x + y * y;
    const double xy2 = 2.0 * x * y;
    const double radial = 1.0 + t * (p[5] + t * p[6]);
    const double radial_derivative = 2.0 * (p[5] + t * 2.0 * p[6]);  // dL/dx = x * this
    const double mx = x * radial + p[7] * xy2 + p[8] * (t + 2.0 * x * x);
    const double my = y * radial + p[7] * (t + 2.0 * y * y) + p[8] * xy2;
    pixel[0] = p[0] * mx + p[2];
    pixel[1] = p[1] * my + p[3];
    // By xi, (x, y) moves along itself.
    const double across = x * y * radial_derivative + 2.0 * (p[7] * x + p[8] * y);
    const double mx_x = radial + x * x * radial_derivative + 2.0 * p[7] * y + 6.0 * p[8] * x;
    const double my_y = radial + y * y * radial_derivative + 6.0 * p[7] * y + 2.0 * p[8] * x;
    const std::array<double, 9> u = {mx,
                                     0.0,
                                     1.0,
                                     0.0,
                                     -p[0] * (mx_x * x + across * y) / denominator,
                                     p[0] * x * t,
                                     p[0] * x * t * t,
                                     p[0] * xy2,
                                     p[0] * (t + 2.0 * x * x)};
    const std::array<double, 9> v = {0.0,
                                     my,
                                     0.0,
                                     1.0,
                                     -p[1] * (across * x + my_y * y) / denominator,
                                     p[1] * y * t,
                                     p[1] * y * t * t,
                                     p[1] * (t + 2.0 * y * y),
                                     p[1] * xy2};
    internal::store(u, du);
    internal::store(v, dv);
    return denominator > 0.0;
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    const double xi = p[4];
    const double q[5] = {p[5], p[6], p[7], p[8], 0.0};
    double m[2];
    if (!internal::to_plane(p, pixel, m[0], m[1]) || !internal::RadialTangential::undistort(q, m, ray)) return false;
    // (x, y) = s / (c + xi) of the unit ray (s, c): lifted back to the unit sphere.
    const double r2 = ray[0] * ray[0] + ray[1] * ray[1];
    const double radicand = 1.0 + (1.0 - xi * xi) * r2;
    if (!(radicand >= 0.0)) return false;
    const double root = std::sqrt(radicand);
    const double factor = (xi + root) / (1.0 + r2);
    ray[0] *= factor;
    ray[1] *= factor;
    ray[2] = (root - xi * r2) / (1.0 + r2);  // factor - xi, which are nearly the same where xi is large
    return internal::normalise(ray);
  }

  /// Where the sphere ends or where the distortion's disc does: |(x, y)| = sin / (cos + xi) = r_max.
  static double max_angle(const double* p) {
    const double xi = p[4];
    const double sphere = std::acos(-limit(xi));
    const double q[5] = {p[5], p[6], p[7], p[8], 0.0};
    const double r = internal::RadialTangential::max_radius(q);
    const double radicand = 1.0 + (1.0 - xi * xi) * r * r;
    if (!(radicand >= 0.0) || !std::isfinite(r * r)) return sphere;
    const double factor = (xi + std::sqrt(radicand)) / (1.0 + r * r);
    return std::min(sphere, std::atan2(factor * r, factor - xi));
  }

  /// Given xi, all of radtan's terms, on its plane.
  static constexpr std::array kShapes = {0.0, 0.03, 0.06, 0.1, 0.15, 0.2, 0.3,  0.4,  0.5,  0.65,  0.8,    1.0, 1.2,
                                         1.5, 1.9,  2.4,  3.2, 4.5,  7.0, 12.0, 25.0, 60.0, 200.0, 1000.0, 1e4};
  static constexpr std::size_t kTerms = 5;
  static bool terms(double xi, const double* ray, double* along_u, double* along_v) {
    const double denominator = internal::unified_sum(xi, 1.0, 1.0, ray[2], ray[0] * ray[0] + ray[1] * ray[1]);
    if (!(denominator > 0.0)) return false;
    const double x = ray[0] / denominator;
    const double y = ray[1] / denominator;
    const double r2 = x * x + y * y;
    const std::array<double, kTerms> u = {x, x * r2, x * r2 * r2, 2.0 * x * y, r2 + 2.0 * x * x};
    const std::array<double, kTerms> v = {y, y * r2, y * r2 * r2, r2 + 2.0 * y * y, 2.0 * x * y};
    std::ranges::copy(u, along_u);
    std::ranges::copy(v, along_v);
    return true;
  }
  static void from_terms(double xi, const double* c, double aspect, const std::array<double, 2>& point, double* p) {
    begin({{c[0], aspect * c[0]}, point}, p);
    p[4] = xi;
    for (std::size_t i = 1; i < kTerms; ++i) p[4 + i] = c[i] / c[0];
  }

  /// Given xi the distortion is linear, as in radtan.h; f on the plane is the central one times 1 + xi. xi has several local
  /// minima.
  static constexpr std::array kStartXi = {1.0, 0.3, 2.0, 4.0};
  static constexpr int kStarts = static_cast<int>(kStartXi.size());
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int start, double* p) {
    p[4] = kStartXi[static_cast<std::size_t>(start)];
    begin(centre, p, 1.0 + p[4]);
    internal::LinearFit<4> fit;
    for (const Correspondence& s : samples) {
      const double denominator = s.ray[2] + p[4];
      if (!(denominator > 0.05)) continue;
      const double x = s.ray[0] / denominator;
      const double y = s.ray[1] / denominator;
      const double r2 = x * x + y * y;
      fit.add({x * r2, x * r2 * r2, 2.0 * x * y, r2 + 2.0 * x * x}, (s.pixel[0] - p[2]) / p[0] - x, s.weight);
      fit.add({y * r2, y * r2 * r2, r2 + 2.0 * y * y, 2.0 * x * y}, (s.pixel[1] - p[3]) / p[1] - y, s.weight);
    }
    fit.solve(p + 5);
  }

  static std::array<double, 2> central_focal_lengths(const double* p) { return {p[0] / (1.0 + p[4]), p[1] / (1.0 + p[4])}; }

  // In lib/models/mei.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  friend struct internal::RayMap<Mei>;
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    using std::sqrt;
    const T r2 = ray[0] * ray[0] + ray[1] * ray[1];
    const T d = sqrt(r2 + ray[2] * ray[2]);
    if (kWithinDomain && !(internal::value_of(ray[2]) > -limit(internal::value_of(p[4])) * internal::value_of(d))) return false;
    const T denominator = internal::unified_sum(p[4], d, T(1.0), ray[2], r2);
    if (!(internal::value_of(denominator) > 0.0)) return false;
    const T q[5] = {p[5], p[6], p[7], p[8], T(0.0)};
    T m[2];
    if (!internal::RadialTangential::distort<kWithinDomain>(q, T(ray[0] / denominator), T(ray[1] / denominator), m))
      return false;
    internal::to_pixel(p, m[0], m[1], pixel);
    return true;
  }

  /// For xi <= 1 the denominator reaches 0 at cos = -xi; for xi > 1 the radius stops growing at cos = -1 / xi.
  static double limit(double xi) { return xi <= 1.0 ? xi : 1.0 / xi; }
};

static_assert(CameraModelType<Mei>);

}  // namespace fca
