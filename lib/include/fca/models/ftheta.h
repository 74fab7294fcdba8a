// SPDX-License-Identifier: BSD-3-Clause
// NVIDIA's f-theta lens, from angle to distance (NVIDIA/ncore@77144a9, sensors/camera.py, FThetaCameraModel with the reference
// polynomial ANGLE_TO_PIXELDIST).
//
//   p      = k1 k2 k3 k4 k5 [px / rad^i]  c d e  cx cy [px]
//   chi    = |(x, y)|,  theta = atan2(chi, z)
//   rho    = k1 theta + k2 theta^2 + ... + k5 theta^5   [px]
//   (X, Y) = rho (x, y) / chi
//   pixel  = (c X + d Y + cx, e X + Y + cy)
//   domain : theta < pi and drho/dtheta > 0 on all of [0, theta]
//
// The file's other polynomial, from distance to angle, is near the inverse and no part of the model: unprojection is the exact
// inverse. The program ends at the file's max_angle_rad, and starts its inverse from the other polynomial.
//
// With k5 = 0 and no shear it is WoodScape's radial polynomial.
//
// Called: "ftheta" in NCore's and gsplat's JSON.
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>
#include <fca/models/polynomial.h>

#include <numbers>

namespace fca {

struct Ftheta : internal::RayMap<Ftheta> {
  static constexpr std::string_view kId = "ftheta";
  static constexpr std::string_view kTitle = "NVIDIA f-theta (5 radial, shear)";
  static constexpr std::string_view kContains = "woodscape";
  static constexpr std::array<std::string_view, 2> kAliases = {"f-theta", "nvidia-ftheta"};
  static constexpr double kInfinity = common_parameter::kInfinity;
  static constexpr std::array kParameters = {Parameter{"k1", "px", 0.0, kInfinity, ParameterGroup::kFocalLength, true},
                                             Parameter{"k2", "px", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"k3", "px", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"k4", "px", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"k5", "px", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"c", "", 0.0, kInfinity, ParameterGroup::kLens, true},
                                             common_parameter::coefficient("d"),
                                             common_parameter::coefficient("e"),
                                             common_parameter::kCx,
                                             common_parameter::kCy};
  /// No format is written with it.
  static constexpr bool kKeptOnly = true;

  static bool unproject(const double* p, const double* pixel, double* ray) {
    const double determinant = p[kC] - p[kD] * p[kE];
    if (!(determinant > 0.0)) return false;
    const double du = pixel[0] - p[kCx];
    const double dv = pixel[1] - p[kCy];
    const double x = (du - p[kD] * dv) / determinant;
    const double y = (p[kC] * dv - p[kE] * du) / determinant;
    const double radius = std::sqrt(x * x + y * y);
    double theta = 0.0;
    if (!std::isfinite(radius) || !angle_of_radius(p, radius, theta)) return false;
    internal::ray_at_angle(theta, x, y, radius, ray);
    return true;
  }

  static double max_angle(const double* p) { return positive_until(derivative_of(p), std::numbers::pi); }

  static std::array<double, 2> principal_point(const double* p) { return {p[kCx], p[kCy]}; }
  /// The shear is left out.
  static std::array<double, 2> central_focal_lengths(const double* p) { return {p[kC] * p[0], p[0]}; }

  /// Given k1 and c by the centre, k2 ... k5 are linear in the radius.
  static constexpr int kStarts = 1;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int /*start*/, double* p) {
    p[0] = centre.focal[1];
    p[kC] = centre.focal[0] / centre.focal[1];
    p[kD] = 0.0;
    p[kE] = 0.0;
    p[kCx] = centre.point[0];
    p[kCy] = centre.point[1];
    internal::LinearFit<kTerms - 1> fit;
    for (const Correspondence& s : samples) {
      const double theta = std::atan2(std::hypot(s.ray[0], s.ray[1]), s.ray[2]);
      const double radius = std::hypot((s.pixel[0] - p[kCx]) / p[kC], s.pixel[1] - p[kCy]);
      const double t2 = theta * theta;
      fit.add({t2, t2 * theta, t2 * t2, t2 * t2 * theta}, radius - p[0] * theta, s.weight);
    }
    fit.solve(p + 1);
  }

  // In lib/models/ftheta.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();
  static void map_pixels(double* p, const PixelMap& map);

 private:
  friend struct internal::RayMap<Ftheta>;
  static constexpr std::size_t kTerms = 5;
  enum Index : std::size_t { kC = kTerms, kD, kE, kCx, kCy };

  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    using internal::value_of;
    using std::atan2;
    using std::sqrt;
    if (!(value_of(p[kC]) > value_of(p[kD]) * value_of(p[kE]))) return false;
    const T chi2 = ray[0] * ray[0] + ray[1] * ray[1];
    T scale;
    if (value_of(chi2) > 0.0) {
      const T chi = sqrt(chi2);
      const T theta = atan2(chi, ray[2]);
      if (kWithinDomain && !in_domain(p, value_of(theta))) return false;
      scale = theta * (p[0] + theta * (p[1] + theta * (p[2] + theta * (p[3] + theta * p[4])))) / chi;
    } else {  // on the axis, where chi has no derivative
      if (!(value_of(ray[2]) > 0.0)) return false;
      scale = p[0] / ray[2];
    }
    const T x = scale * ray[0];
    const T y = scale * ray[1];
    pixel[0] = p[kC] * x + p[kD] * y + p[kCx];
    pixel[1] = p[kE] * x + y + p[kCy];
    return true;
  }

  template <class T>
  static bool in_domain(const T* p, double theta) {
    std::array<double, kTerms> k;
    for (std::size_t i = 0; i < kTerms; ++i) k[i] = internal::value_of(p[i]);
    return theta < std::numbers::pi && positive_on(derivative_of(k.data()), theta);
  }

  /// drho/dtheta as a polynomial in theta.
  static std::array<double, kTerms> derivative_of(const double* k) {
    return {k[0], 2.0 * k[1], 3.0 * k[2], 4.0 * k[3], 5.0 * k[4]};
  }

  /// rho(theta) = radius, from the lens without k2 ... k5.
  static bool angle_of_radius(const double* p, double radius, double& theta) {
    const std::array<double, kTerms> derivative_coefficients = derivative_of(p);
    const auto rho = [&](double x, double& value, double& derivative) {
      value = x * (p[0] + x * (p[1] + x * (p[2] + x * (p[3] + x * p[4]))));
      derivative = evaluate_polynomial(derivative_coefficients, x);
    };
    const auto inside = [&](double x) { return x < std::numbers::pi && positive_on(derivative_coefficients, x); };
    return invert_inside(
        rho, radius, radius / p[0], inside, [&] { return max_angle(p); }, theta);
  }
};

static_assert(CameraModelType<Ftheta>);

}  // namespace fca
