// SPDX-License-Identifier: BSD-3-Clause
// Double Sphere (Usenko, Demmel, Cremers 2018, "The Double Sphere Camera Model", sec. III-C).
//
//   p      = fx fy cx cy [px]  alpha in [0, 1]  xi > -1
//   d1     = |(x, y, z)|,  k = xi d1 + z,  d2 = sqrt(x^2 + y^2 + k^2)
//   m      = (x, y) / (alpha d2 + (1 - alpha) k)
//   pixel  = (fx m_x + cx, fy m_y + cy)
//   domain : k > -w d2  and  d1 + xi z > 0,   w = min(alpha / (1 - alpha), (1 - alpha) / alpha)
//
// Where the domain comes from: with c = cos, s = sin of the angle, dm/dangle has the sign of
//   (1 + xi c) (alpha k + (1 - alpha) d2),
// so the radius grows until k / d2 = -(1 - alpha) / alpha, or, for xi > 1, until c = -1 / xi; the denominator reaches 0 at
// k / d2 = -alpha / (1 - alpha). The published bound z > -w2 d1 (Usenko eq. 43-45, copied by the paper) is too strict by up to
// 3 degrees for xi in [-0.3, -0.1] and 5 to 40 for xi in [0.5, 1] (ERRATA 6); for alpha > 0.85 and xi < 0, and for xi > 1, it
// is too lenient and lets the image fold.
//
// Called: Kalibr ds-none (order xi alpha fu fv pu pv); urbste/ORB_SLAM3 DoubleSphere.
#pragma once

#include <fca/models/model_traits.h>

#include <algorithm>

namespace fca {

struct Ds : internal::FocalLengthsFirst, internal::RayMap<Ds> {
  static constexpr std::string_view kId = "ds";
  static constexpr std::string_view kTitle = "Double Sphere";
  static constexpr bool kRound = true;
  static constexpr std::string_view kContains = "ucm";
  static constexpr std::array<std::string_view, 3> kAliases = {"double-sphere", "doublesphere", "ds-none"};
  static constexpr std::array kParameters = {
      common_parameter::kFx,
      common_parameter::kFy,
      common_parameter::kCx,
      common_parameter::kCy,
      Parameter{"alpha", "", 0.0, 1.0, ParameterGroup::kLens},
      Parameter{
          "xi", "", -1.0, common_parameter::kInfinity, ParameterGroup::kLens, true, common_parameter::kInfinity, {-1.0, 1.0}}};

  static bool formula_and_derivatives(const double* p, const double* ray, double* pixel, double* du, double* dv) {
    const double alpha = p[4];
    const double xi = p[5];
    const double r2 = ray[0] * ray[0] + ray[1] * ray[1];
    const double k = xi + ray[2];
    const double d2 = std::sqrt(r2 + k * k);
    const double denominator = internal::unified_sum(alpha, d2, 1.0 - alpha, k, r2);
    internal::radial_derivatives<2>(p, ray, denominator, {d2 - k, alpha * k / d2 + (1.0 - alpha)}, pixel, du, dv);
    return denominator > 0.0;
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    const double alpha = p[4];
    const double xi = p[5];
    double mx = 0.0;
    double my = 0.0;
    if (!(xi > -1.0) || !internal::to_plane(p, pixel, mx, my)) return false;
    const double r2 = mx * mx + my * my;
    const double inner = 1.0 - (2.0 * alpha - 1.0) * r2;
    if (!(inner >= 0.0)) return false;
    const double denominator = alpha * std::sqrt(inner) + (1.0 - alpha);
    if (!(denominator > 0.0)) return false;
    const double mz = (1.0 - alpha * alpha * r2) / denominator;
    const double outer = mz * mz + (1.0 - xi * xi) * r2;
    if (!(outer >= 0.0)) return false;  // xi > 1: no point of the first sphere is seen there
    const double factor = (mz * xi + std::sqrt(outer)) / (mz * mz + r2);
    if (!(factor > 0.0)) return false;  // nor there: its mirror image is
    ray[0] = factor * mx;
    ray[1] = factor * my;
    ray[2] = factor * mz - xi;
    return internal::normalise(ray);
  }

  /// The angle where k / d2 reaches -w, that is c + xi = -w sqrt(1 + 2 xi c + xi^2); for xi > 1, k is positive everywhere and
  /// the limit is 1 + xi c = 0.
  static double max_angle(const double* p) {
    const double alpha = p[4];
    const double xi = p[5];
    if (xi > 1.0) return std::acos(-1.0 / xi);
    const double w = limit(alpha);
    // Squared and solved for c = cos(angle); the root with c + xi <= 0 is the one meant.
    const double c = -xi * (1.0 - w * w) - w * std::sqrt(std::max(0.0, 1.0 - xi * xi * (1.0 - w * w)));
    return std::acos(std::clamp(c, -1.0, 1.0));
  }

  /// Several local minima on both sides of a singular ridge at xi = 0: several starts on each. Given xi, alpha is linear:
  /// (u - c)(alpha d2 + (1 - alpha) k) = f (x, y).
  static constexpr std::array kStartXi = {-0.8, -0.6, -0.2, 0.3, 0.7, 1.4};
  static constexpr int kStarts = static_cast<int>(kStartXi.size());
  /// xi: the pixels are nearly those of another alpha and xi.
  static constexpr std::size_t kFolded = 5;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int start, double* p) {
    const double xi = kStartXi[static_cast<std::size_t>(start)];
    begin(centre, p, 1.0 + xi);
    p[5] = xi;
    double numerator = 0.0;
    double denominator = 0.0;
    for (const Correspondence& s : samples) {
      const auto& [x, y, z] = s.ray;
      const double k = xi + z;
      const double d2 = std::sqrt(x * x + y * y + k * k);
      const double du = s.pixel[0] - p[2];
      const double dv = s.pixel[1] - p[3];
      numerator += s.weight * (d2 - k) * (du * (p[0] * x - k * du) + dv * (p[1] * y - k * dv));
      denominator += s.weight * (d2 - k) * (d2 - k) * (du * du + dv * dv);
    }
    const double alpha = numerator / denominator;
    p[4] = std::isfinite(alpha) ? std::clamp(alpha, 0.05, 0.95) : 0.6;
  }

  static std::array<double, 2> central_focal_lengths(const double* p) { return {p[0] / (1.0 + p[5]), p[1] / (1.0 + p[5])}; }

  // In lib/models/ds.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  friend struct internal::RayMap<Ds>;
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    using std::sqrt;
    const T& alpha = p[4];
    const T& xi = p[5];
    const T r2 = ray[0] * ray[0] + ray[1] * ray[1];
    const T d1 = sqrt(r2 + ray[2] * ray[2]);
    const T k = internal::value_of(xi) > 0.0 ? internal::unified_sum(xi, d1, T(1.0), ray[2], r2) : T(xi * d1 + ray[2]);
    const T d2 = sqrt(r2 + k * k);
    if (kWithinDomain && !in_domain(internal::value_of(alpha), internal::value_of(xi), internal::value_of(ray[2]),
                                    internal::value_of(d1), internal::value_of(k), internal::value_of(d2))) {
      return false;
    }
    const T denominator = internal::unified_sum(alpha, d2, T(T(1.0) - alpha), k, r2);
    if (!(internal::value_of(denominator) > 0.0)) return false;
    internal::to_pixel(p, T(ray[0] / denominator), T(ray[1] / denominator), pixel);
    return true;
  }

  static double limit(double alpha) { return alpha <= 0.5 ? alpha / (1.0 - alpha) : (1.0 - alpha) / alpha; }

  static bool in_domain(double alpha, double xi, double z, double d1, double k, double d2) {
    return xi > -1.0 && d1 + xi * z > 0.0 && k > -limit(alpha) * d2;
  }
};

static_assert(CameraModelType<Ds>);

}  // namespace fca
