// SPDX-License-Identifier: BSD-3-Clause
#include "kalibr_formulas.h"

#include <algorithm>
#include <cmath>

namespace fca::consumers::kalibr {
namespace {

using Distortion = std::function<Pixel(const Pixel&)>;

std::optional<Pixel> to_pixel(const Intrinsics& k, const Pixel& m) {
  const Pixel pixel = {k.fu * m[0] + k.pu, k.fv * m[1] + k.pv};
  if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1])) return std::nullopt;
  return pixel;
}

// aslam/cameras/implementation/RadialTangentialDistortion.hpp
Pixel distort_radtan(const Pixel& m, const std::array<double, 4>& coeffs) {
  const auto& [k1, k2, p1, p2] = coeffs;
  const auto& [x, y] = m;
  const double r2 = x * x + y * y;
  const double radial = k1 * r2 + k2 * r2 * r2;
  return {x + x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y + y * radial + 2.0 * p2 * x * y + p1 * (r2 + 2.0 * y * y)};
}

// aslam/cameras/implementation/EquidistantDistortion.hpp: works on the normalised pinhole point, so it ends before 90 deg.
Pixel distort_equidistant(const Pixel& m, const std::array<double, 4>& coeffs) {
  const auto& [k1, k2, k3, k4] = coeffs;
  const double r = std::sqrt(m[0] * m[0] + m[1] * m[1]);
  const double theta = std::atan(r);
  const double theta2 = theta * theta;
  const double theta4 = theta2 * theta2;
  const double theta_d = theta * (1.0 + k1 * theta2 + k2 * theta4 + k3 * theta4 * theta2 + k4 * theta4 * theta4);
  const double scaling = r > 1e-8 ? theta_d / r : 1.0;
  return {m[0] * scaling, m[1] * scaling};
}

// aslam/cameras/implementation/FovDistortion.hpp
constexpr double kSmall = 1e-5;
Pixel distort_fov(const Pixel& m, double w) {
  const double r = std::sqrt(m[0] * m[0] + m[1] * m[1]);
  const double two_tan = 2.0 * std::tan(w / 2.0);
  const double scaling = w * w < kSmall ? 1.0 : r * r < kSmall ? two_tan / w : std::atan(r * two_tan) / (r * w);
  return {m[0] * scaling, m[1] * scaling};
}

/// By how much it is off where it takes the radius for small, in units of the focal length: atan(x) = x - x^3 / 3 + ..., at
/// the largest such radius.
double series_error_of_fov(double w) {
  const double x = std::sqrt(kSmall) * 2.0 * std::tan(w / 2.0);
  return x * x * x / (3.0 * w);
}

Distortion make_distortion(const KalibrCamera& camera) {
  if (camera.distortion_model == "radtan") return [c = camera.coeffs](const Pixel& m) { return distort_radtan(m, c); };
  if (camera.distortion_model == "equidistant")
    return [c = camera.coeffs](const Pixel& m) { return distort_equidistant(m, c); };
  if (camera.distortion_model == "fov") return [w = camera.coeffs[0]](const Pixel& m) { return distort_fov(m, w); };
  return [](const Pixel& m) { return m; };
}

double norm(const Ray& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

// aslam/cameras/implementation/PinholeProjection.hpp
Projection make_pinhole(const KalibrCamera& camera) {
  return [k = camera.intrinsics, distort = make_distortion(camera)](const Ray& p) -> std::optional<Pixel> {
    if (!(p[2] > 0.0)) return std::nullopt;
    const double rz = 1.0 / p[2];
    return to_pixel(k, distort({p[0] * rz, p[1] * rz}));
  };
}

// aslam/cameras/implementation/OmniProjection.hpp
Projection make_omni(const KalibrCamera& camera) {
  const double xi = camera.model[0];
  const double fov_parameter = xi <= 1.0 ? xi : 1.0 / xi;
  return [k = camera.intrinsics, distort = make_distortion(camera), xi, fov_parameter](const Ray& p) -> std::optional<Pixel> {
    const double d = norm(p);
    if (!(p[2] > -fov_parameter * d)) return std::nullopt;
    const double rz = 1.0 / (p[2] + xi * d);
    return to_pixel(k, distort({p[0] * rz, p[1] * rz}));
  };
}

double cone_of(double alpha) { return alpha <= 0.5 ? alpha / (1.0 - alpha) : (1.0 - alpha) / alpha; }

// aslam/cameras/implementation/ExtendedUnifiedProjection.hpp
Projection make_eucm(const KalibrCamera& camera) {
  const auto [alpha, beta] = camera.model;
  return [k = camera.intrinsics, alpha = alpha, beta = beta, w = cone_of(alpha)](const Ray& p) -> std::optional<Pixel> {
    const double d = std::sqrt(beta * (p[0] * p[0] + p[1] * p[1]) + p[2] * p[2]);
    if (!(p[2] > -w * d)) return std::nullopt;
    const double denominator = alpha * d + (1.0 - alpha) * p[2];
    return to_pixel(k, {p[0] / denominator, p[1] / denominator});
  };
}

// aslam/cameras/implementation/DoubleSphereProjection.hpp
Projection make_ds(const KalibrCamera& camera) {
  const auto [xi, alpha] = camera.model;
  const double w1 = cone_of(alpha);
  const double w2 = (w1 + xi) / std::sqrt(2.0 * w1 * xi + xi * xi + 1.0);
  return [k = camera.intrinsics, xi = xi, alpha = alpha, w2](const Ray& p) -> std::optional<Pixel> {
    const double d1 = norm(p);
    if (!(p[2] > -w2 * d1)) return std::nullopt;
    const double shifted = xi * d1 + p[2];
    const double d2 = std::sqrt(p[0] * p[0] + p[1] * p[1] + shifted * shifted);
    const double denominator = alpha * d2 + (1.0 - alpha) * shifted;
    return to_pixel(k, {p[0] / denominator, p[1] / denominator});
  };
}

}  // namespace

Projection make_projection(const KalibrCamera& camera) {
  if (camera.camera_model == "omni") return make_omni(camera);
  if (camera.camera_model == "eucm") return make_eucm(camera);
  if (camera.camera_model == "ds") return make_ds(camera);
  return make_pinhole(camera);
}

double approximation_px(const KalibrCamera& camera) {
  if (camera.distortion_model != "fov") return 0.0;
  return std::max(camera.intrinsics.fu, camera.intrinsics.fv) * series_error_of_fov(camera.coeffs[0]);
}

}  // namespace fca::consumers::kalibr
