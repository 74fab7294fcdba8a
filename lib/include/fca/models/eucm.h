// SPDX-License-Identifier: BSD-3-Clause
// Enhanced Unified Camera Model (Khomutenko, Garcia, Martinet 2016; in the form of Usenko, Demmel, Cremers 2018, sec. III-B).
//
//   p      = fx fy cx cy [px]  alpha in [0, 1]  beta > 0
//   d      = sqrt(beta (x^2 + y^2) + z^2)
//   m      = (x, y) / (alpha d + (1 - alpha) z)
//   pixel  = (fx m_x + cx, fy m_y + cy)
//   domain : z > -w d,   w = alpha / (1 - alpha) for alpha <= 0.5 (the denominator reaches 0)
//                        w = (1 - alpha) / alpha for alpha >  0.5 (the image radius stops growing)
//            on the plane: beta (2 alpha - 1) |m|^2 <= 1
//
// Differs from the paper (Lee, eq. of sec. II-B): its domain for alpha <= 0.5, all of R^3, is wrong (ERRATA 5).
// Called: Kalibr eucm-none; slam_no_opt and fisheye-ORB-SLAM: Camera.k1 = alpha, Camera.k2 = beta.
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>

#include <algorithm>

namespace fca {

namespace internal {

/// Shared by UCM (beta = 1) and EUCM.
struct UnifiedPlane {
  /// The domain's limit of z / d.
  static double min_z_over_d(double alpha) { return alpha <= 0.5 ? -alpha / (1.0 - alpha) : -(1.0 - alpha) / alpha; }

  /// (x, y, z) -> m; false where the formula has no value or, if that is asked, outside the domain.
  template <bool kWithinDomain, class T>
  static bool project(const T& alpha, const T& beta, const T* ray, T* m) {
    using std::sqrt;
    const T r2 = beta * (ray[0] * ray[0] + ray[1] * ray[1]);
    const T d = sqrt(r2 + ray[2] * ray[2]);
    if (kWithinDomain && !(value_of(ray[2]) > min_z_over_d(value_of(alpha)) * value_of(d))) return false;
    const T denominator = unified_sum(alpha, d, T(T(1.0) - alpha), ray[2], r2);
    if (!(value_of(denominator) > 0.0)) return false;
    m[0] = ray[0] / denominator;
    m[1] = ray[1] / denominator;
    return true;
  }

  /// m -> z of the point (m, z) on its ray; false outside the domain.
  static bool lift(double alpha, double beta, double r2, double& z) {
    const double radicand = 1.0 - (2.0 * alpha - 1.0) * beta * r2;
    if (!(radicand >= 0.0)) return false;
    const double denominator = alpha * std::sqrt(radicand) + (1.0 - alpha);
    if (!(denominator > 0.0)) return false;
    z = (1.0 - beta * alpha * alpha * r2) / denominator;
    return std::isfinite(z);
  }

  /// With z / d at its limit -w, tan(angle) follows from d^2 = beta s^2 + c^2: c = -w sqrt(beta) s / sqrt(1 - w^2).
  static double max_angle(double alpha, double beta) {
    const double w = -min_z_over_d(alpha);
    return std::atan2(std::sqrt(std::max(0.0, 1.0 - w * w)), -w * std::sqrt(beta));
  }

  /// Least squares for alpha with the other parameters given: (u - c)(alpha d + (1 - alpha) z) = f (x, y), that is
  /// alpha (d - z)(u - c) = f x - z (u - c) (paper sec. II-A, parentheses as in ERRATA 1).
  static double linear_alpha(std::span<const Correspondence> samples, const double* p, double beta) {
    double numerator = 0.0;
    double denominator = 0.0;
    for (const Correspondence& s : samples) {
      const auto& [x, y, z] = s.ray;
      const double d = std::sqrt(beta * (x * x + y * y) + z * z);
      const double du = s.pixel[0] - p[2];
      const double dv = s.pixel[1] - p[3];
      numerator += s.weight * (d - z) * (du * (p[0] * x - z * du) + dv * (p[1] * y - z * dv));
      denominator += s.weight * (d - z) * (d - z) * (du * du + dv * dv);
    }
    const double alpha = numerator / denominator;
    return std::isfinite(alpha) ? std::clamp(alpha, 0.05, 0.95) : 0.5;
  }
};

}  // namespace internal

struct Eucm : internal::FocalLengthsFirst, internal::RayMap<Eucm> {
  static constexpr std::string_view kId = "eucm";
  static constexpr std::string_view kTitle = "Enhanced Unified Camera Model";
  static constexpr bool kRound = true;
  static constexpr std::string_view kContains = "ucm";
  static constexpr std::array<std::string_view, 3> kAliases = {"eucm-none", "extended-unified", "enhanced-unified"};
  static constexpr std::array kParameters = {
      common_parameter::kFx,
      common_parameter::kFy,
      common_parameter::kCx,
      common_parameter::kCy,
      Parameter{"alpha", "", 0.0, 1.0, ParameterGroup::kLens},
      Parameter{
          "beta", "", 0.0, common_parameter::kInfinity, ParameterGroup::kLens, true, common_parameter::kInfinity, {0.1, 10.0}}};

  static bool formula_and_derivatives(const double* p, const double* ray, double* pixel, double* du, double* dv) {
    const double alpha = p[4];
    const double r2 = ray[0] * ray[0] + ray[1] * ray[1];
    const double d = std::sqrt(p[5] * r2 + ray[2] * ray[2]);
    const double denominator = internal::unified_sum(alpha, d, 1.0 - alpha, ray[2], p[5] * r2);
    internal::radial_derivatives<2>(p, ray, denominator, {d - ray[2], 0.5 * alpha * r2 / d}, pixel, du, dv);
    return denominator > 0.0;
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    if (!internal::to_plane(p, pixel, ray[0], ray[1])) return false;
    const double r2 = ray[0] * ray[0] + ray[1] * ray[1];
    return internal::UnifiedPlane::lift(p[4], p[5], r2, ray[2]) && internal::normalise(ray);
  }

  static double max_angle(const double* p) { return internal::UnifiedPlane::max_angle(p[4], p[5]); }

  static constexpr int kStarts = 1;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int /*start*/, double* p) {
    begin(centre, p);
    if (linear_start(samples, p)) return;
    p[5] = 1.0;  // as UCM
    p[4] = internal::UnifiedPlane::linear_alpha(samples, p, p[5]);
  }

  // In lib/models/eucm.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();

 private:
  /// With m the point on the normalised plane, r = |(x, y)| and w = r / |m| - z = alpha (d - z), the definition of d squared is
  /// linear in alpha beta and 1 / alpha: alpha beta r^2 - w^2 / alpha = 2 z w. Weighted so that the residual is about that of
  /// the pixel. False where the answer is no camera: a lens without barrel distortion.
  static bool linear_start(std::span<const Correspondence> samples, double* p) {
    internal::LinearFit<2> fit;
    for (const Correspondence& s : samples) {
      const double mx = (s.pixel[0] - p[2]) / p[0];
      const double my = (s.pixel[1] - p[3]) / p[1];
      const double m2 = mx * mx + my * my;
      const double r2 = s.ray[0] * s.ray[0] + s.ray[1] * s.ray[1];
      if (!(m2 > 0.0 && r2 > 0.0)) continue;
      const double w = std::sqrt(r2 / m2) - s.ray[2];
      fit.add({r2, -w * w}, 2.0 * s.ray[2] * w, s.weight * m2 * m2 / r2);
    }
    double solution[2];
    fit.solve(solution);
    const double alpha = 1.0 / solution[1];
    const double beta = solution[0] / alpha;
    if (!(alpha > 0.0 && alpha < 1.0 && beta > 0.0 && std::isfinite(beta))) return false;
    p[4] = alpha;
    p[5] = beta;
    return true;
  }

  friend struct internal::RayMap<Eucm>;
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    T m[2];
    if (!internal::UnifiedPlane::project<kWithinDomain>(p[4], p[5], ray, m)) return false;
    internal::to_pixel(p, m[0], m[1], pixel);
    return true;
  }
};

static_assert(CameraModelType<Eucm>);

}  // namespace fca
