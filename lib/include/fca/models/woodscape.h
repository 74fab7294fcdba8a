// SPDX-License-Identifier: BSD-3-Clause
// WoodScape's radial polynomial (Yogamani et al. 2019, "WoodScape: a multi-task, multi-camera fisheye dataset for autonomous
// driving"; calibration.txt and scripts/calibration/projection.py of the dataset, class RadialPolyCamProjection).
//
//   p      = k1 k2 k3 k4 [px / rad^i]  aspect_ratio  cx cy [px]
//   chi    = |(x, y)|,  theta = atan2(chi, z)
//   rho    = k1 theta + k2 theta^2 + k3 theta^3 + k4 theta^4   [px]
//   pixel  = (rho x / chi + cx, aspect_ratio rho y / chi + cy)
//   domain : theta < pi and drho/dtheta > 0 on all of [0, theta]
//
// cx and cy are the principal point itself: the file's cx_offset and cy_offset, which count from the image's centre, with
// width / 2 - 0.5 and height / 2 - 0.5 added by the format.
//
// Differs from the dataset's program: it has no domain, takes the smallest real root of the quartic as the angle of a pixel,
// and returns the centre for a ray straight behind.
//
// Called: "model": "radial_poly" in the dataset's JSON files. Kannala-Brandt has odd powers only, so neither contains the
// other.
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>
#include <fca/models/polynomial.h>

#include <numbers>

namespace fca {

struct Woodscape : internal::RayMap<Woodscape> {
  static constexpr std::string_view kId = "woodscape";
  static constexpr std::string_view kTitle = "WoodScape radial polynomial";
  static constexpr std::array<std::string_view, 2> kAliases = {"radial-poly", "radial-polynomial"};
  static constexpr double kInfinity = common_parameter::kInfinity;
  static constexpr std::array kParameters = {Parameter{"k1", "px", 0.0, kInfinity, ParameterGroup::kFocalLength, true},
                                             Parameter{"k2", "px", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"k3", "px", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"k4", "px", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"aspect_ratio", "", 0.0, kInfinity, ParameterGroup::kLens, true},
                                             common_parameter::kCx,
                                             common_parameter::kCy};

  static bool unproject(const double* p, const double* pixel, double* ray) {
    const double x = pixel[0] - p[5];
    const double y = (pixel[1] - p[6]) / p[4];
    const double radius = std::sqrt(x * x + y * y);
    double theta = 0.0;
    if (!std::isfinite(radius) || !angle_of_radius(p, radius, theta)) return false;
    internal::ray_at_angle(theta, x, y, radius, ray);
    return true;
  }

  static double max_angle(const double* p) { return positive_until(derivative_of(p), std::numbers::pi); }

  static std::array<double, 2> principal_point(const double* p) { return {p[5], p[6]}; }
  static std::array<double, 2> central_focal_lengths(const double* p) { return {p[0], p[4] * p[0]}; }

  /// theta, theta^2, ... theta^4 in the direction of (x, y), with k1 ... k4.
  static constexpr std::size_t kTerms = 4;
  static bool terms(const double* ray, double* along_u, double* along_v) {
    const double chi = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1]);
    if (!(chi > 0.0) && !(ray[2] > 0.0)) return false;
    const double theta = std::atan2(chi, ray[2]);
    double power = chi > 0.0 ? theta / chi : 1.0 / ray[2];
    for (std::size_t i = 0; i < kTerms; ++i, power *= theta) {
      along_u[i] = ray[0] * power;
      along_v[i] = ray[1] * power;
    }
    return true;
  }
  static void from_terms(const double* c, double aspect, const std::array<double, 2>& point, double* p) {
    for (std::size_t i = 0; i < kTerms; ++i) p[i] = c[i];
    p[4] = aspect;
    p[5] = point[0];
    p[6] = point[1];
  }

  /// Given k1 and the aspect ratio by the centre, k2..k4 are linear in the radius.
  static constexpr int kStarts = 1;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int /*start*/, double* p) {
    p[0] = centre.focal[0];
    p[4] = centre.focal[1] / centre.focal[0];
    p[5] = centre.point[0];
    p[6] = centre.point[1];
    internal::LinearFit<3> fit;
    for (const Correspondence& s : samples) {
      const double theta = std::atan2(std::hypot(s.ray[0], s.ray[1]), s.ray[2]);
      const double radius = std::hypot(s.pixel[0] - p[5], (s.pixel[1] - p[6]) / p[4]);
      const double t2 = theta * theta;
      fit.add({t2, t2 * theta, t2 * t2}, radius - p[0] * theta, s.weight);
    }
    fit.solve(p + 1);
  }

  // In lib/models/woodscape.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();
  static void map_pixels(double* p, const PixelMap& map);

 private:
  friend struct internal::RayMap<Woodscape>;
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    using std::atan2;
    using std::sqrt;
    const T chi2 = ray[0] * ray[0] + ray[1] * ray[1];
    T scale;
    if (internal::value_of(chi2) > 0.0) {
      const T chi = sqrt(chi2);
      const T theta = atan2(chi, ray[2]);
      if (kWithinDomain && !in_domain(p, internal::value_of(theta))) return false;
      scale = theta * (p[0] + theta * (p[1] + theta * (p[2] + theta * p[3]))) / chi;
    } else {  // on the axis, where chi has no derivative
      if (!(internal::value_of(ray[2]) > 0.0)) return false;
      scale = p[0] / ray[2];
    }
    pixel[0] = scale * ray[0] + p[5];
    pixel[1] = p[4] * scale * ray[1] + p[6];
    return true;
  }

  template <class T>
  static bool in_domain(const T* p, double theta) {
    const double k[4] = {internal::value_of(p[0]), internal::value_of(p[1]), internal::value_of(p[2]),
                         internal::value_of(p[3])};
    return theta < std::numbers::pi && positive_on(derivative_of(k), theta);
  }

  /// drho/dtheta as a polynomial in theta.
  static std::array<double, 4> derivative_of(const double* k) { return {k[0], 2.0 * k[1], 3.0 * k[2], 4.0 * k[3]}; }

  /// rho(theta) = radius, from the lens without k2..k4.
  static bool angle_of_radius(const double* p, double radius, double& theta) {
    const std::array<double, 4> derivative_coefficients = derivative_of(p);
    const auto rho = [&](double x, double& value, double& derivative) {
      value = x * (p[0] + x * (p[1] + x * (p[2] + x * p[3])));
      derivative = evaluate_polynomial(derivative_coefficients, x);
    };
    const auto inside = [&](double x) { return x < std::numbers::pi && positive_on(derivative_coefficients, x); };
    return invert_inside(
        rho, radius, radius / p[0], inside, [&] { return max_angle(p); }, theta);
  }
};

static_assert(CameraModelType<Woodscape>);

}  // namespace fca
