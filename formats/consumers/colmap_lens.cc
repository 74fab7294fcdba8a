// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's camera models. From colmap/colmap@5d968cf (4.2.0.dev0, 2026-08-08), src/colmap/sensor/models.h (ImgFromCam with
// check_cheirality of each model). The centre of COLMAP's first pixel is (0.5, 0.5).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "colmap.h"

namespace fca::consumers::colmap {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Numbers = std::vector<double>;

Pixel keep(const Numbers& /*c*/, double u, double v) { return {u, v}; }

Pixel radial(const Numbers& c, double u, double v) {
  const double r2 = u * u + v * v;
  const double more = c[0] * r2 + (c.size() > 1 ? c[1] * r2 * r2 : 0.0);
  return {u + u * more, v + v * more};
}

Pixel brown(const Numbers& c, double u, double v) {
  const double u2 = u * u;
  const double uv = u * v;
  const double v2 = v * v;
  const double r2 = u2 + v2;
  const double r4 = r2 * r2;
  double factor = 1.0 + c[0] * r2 + c[1] * r4;
  if (c.size() == 8) factor = (factor + c[4] * r4 * r2) / (1.0 + c[5] * r2 + c[6] * r4 + c[7] * r4 * r2);
  return {u * factor + 2.0 * c[2] * uv + c[3] * (r2 + 2.0 * u2), v * factor + 2.0 * c[3] * uv + c[2] * (r2 + 2.0 * v2)};
}

/// FisheyeFromNormal, then as many powers of theta as there are coefficients.
Pixel fisheye(const Numbers& c, double u, double v) {
  const double r = std::sqrt(u * u + v * v);
  const double scale = r > kEpsilon ? std::atan(r) / r : 1.0;
  const double theta2 = scale * r * scale * r;
  double sum = 0.0;
  for (std::size_t i = c.size(); i-- > 0;) sum = theta2 * (c[i] + sum);
  return {scale * u * (1.0 + sum), scale * v * (1.0 + sum)};
}

/// ThinPrismFisheyeCameraModel: its terms are of the undistorted angle.
Pixel thin_prism(const Numbers& c, double u, double v) {
  const Pixel point = fisheye({}, u, v);
  const auto [x, y] = point;
  const double r2 = x * x + y * y;
  const double radial = c[0] * r2 + c[1] * r2 * r2 + c[4] * r2 * r2 * r2 + c[5] * r2 * r2 * r2 * r2;
  return {x + x * radial + 2.0 * c[2] * x * y + c[3] * (r2 + 2.0 * x * x) + c[6] * r2,
          y + y * radial + 2.0 * c[3] * x * y + c[2] * (r2 + 2.0 * y * y) + c[7] * r2};
}

/// RadTanThinPrismFisheyeModel: its further terms are of the distorted point.
Pixel rad_tan_thin_prism(const Numbers& c, double u, double v) {
  const Pixel point = fisheye({c.begin(), c.begin() + 6}, u, v);
  const auto [x, y] = point;
  const double r2 = x * x + y * y;
  const double across = 2.0 * (c[6] * x + c[7] * y);
  return {x + across * x + r2 * c[6] + r2 * (c[8] + r2 * c[9]), y + across * y + r2 * c[7] + r2 * (c[10] + r2 * c[11])};
}

Pixel division(const Numbers& c, double u, double v) {
  const double factor = 2.0 / (1.0 + std::sqrt(1.0 - 4.0 * c[0] * (u * u + v * v)));
  return {u * factor, v * factor};
}

double exact_fov_factor(double omega, double radius) {
  return std::atan(radius * 2.0 * std::tan(omega / 2.0)) / (radius * omega);
}

/// With a series for small omegas and near the axis.
double fov_factor(double omega, double radius2) {
  constexpr double kSmall = 1e-4;
  const double omega2 = omega * omega;
  if (omega2 < kSmall) return omega2 * radius2 / 3.0 - omega2 / 12.0 + 1.0;
  if (radius2 >= kSmall) return exact_fov_factor(omega, std::sqrt(radius2));
  const double half = std::tan(omega / 2.0);
  return -2.0 * half * (4.0 * radius2 * half * half - 3.0) / (3.0 * omega);
}

Pixel fov(const Numbers& c, double u, double v) {
  const double factor = fov_factor(c[0], u * u + v * v);
  return {u * factor, v * factor};
}

/// How far the series are from the formula, in units of the focal length, over a wide lens.
double fov_series_error(double omega) {
  double worst = 0.0;
  constexpr double kWidest = 20.0;
  for (double radius = 0.0099; radius < kWidest; radius *= 1.1) {
    const double error = radius * std::abs(fov_factor(omega, radius * radius) - exact_fov_factor(omega, radius));
    worst = std::max(worst, std::isfinite(error) ? error : 0.0);
  }
  return worst;
}

constexpr std::array kModels = {
    Model{"SIMPLE_PINHOLE", 1, 0, &keep},
    Model{"PINHOLE", 2, 0, &keep},
    Model{"SIMPLE_RADIAL", 1, 1, &radial},
    Model{"RADIAL", 1, 2, &radial},
    Model{"OPENCV", 2, 4, &brown},
    Model{"OPENCV_FISHEYE", 2, 4, &fisheye},
    Model{"FULL_OPENCV", 2, 8, &brown},
    Model{"FOV", 2, 1, &fov},
    Model{"SIMPLE_RADIAL_FISHEYE", 1, 1, &fisheye},
    Model{"RADIAL_FISHEYE", 1, 2, &fisheye},
    Model{"THIN_PRISM_FISHEYE", 2, 8, &thin_prism},
    Model{"RAD_TAN_THIN_PRISM_FISHEYE", 2, 12, &rad_tan_thin_prism, "3.11"},
    Model{"SIMPLE_DIVISION", 1, 1, &division, "4.0"},
    Model{"DIVISION", 2, 1, &division, "4.0"},
    Model{"SIMPLE_FISHEYE", 1, 0, &fisheye, "4.0"},
    Model{"FISHEYE", 2, 0, &fisheye, "4.0"},
    Model{"EUCM", 2, 2, nullptr, "4.1"},
    Model{"EQUIRECTANGULAR", 0, 0, nullptr, "4.1"},
};

std::optional<Pixel> img_from_cam(const Model& model, const Numbers& p, const Ray& ray) {
  const auto [u, v, w] = ray;
  const std::size_t focal = model.focal_lengths;
  const Numbers c(p.begin() + static_cast<std::ptrdiff_t>(focal) + 2, p.end());
  if (!(w >= kEpsilon)) return std::nullopt;
  Pixel point{};
  if (model.name == "EUCM") {
    const double rho2 = c[1] * (u * u + v * v) + w * w;
    if (rho2 < 0.0) return std::nullopt;
    const double denominator = c[0] * std::sqrt(rho2) + (1.0 - c[0]) * w;
    if (!(denominator >= kEpsilon)) return std::nullopt;
    point = {u / denominator, v / denominator};
  } else if (model.bend != nullptr) {
    point = model.bend(c, u / w, v / w);
  } else {
    return std::nullopt;
  }
  constexpr double kCentre = 0.5;
  return Pixel{p[0] * point[0] + p[focal] - kCentre, p[focal - 1] * point[1] + p[focal + 1] - kCentre};
}

}  // namespace

std::span<const Model> all_models() { return kModels; }

const Model* find_model(std::string_view name) {
  const auto* const found = std::ranges::find(kModels, name, &Model::name);
  return found == kModels.end() ? nullptr : &*found;
}

ConsumerCamera seen_camera(std::string name, const Model& model, const std::vector<double>& params) {
  ConsumerCamera seen;
  seen.name = std::move(name);
  seen.model = model.name;
  if (seen.model == "FOV") seen.approximation_px = std::max(params[0], params[1]) * fov_series_error(params[4]);
  seen.project = [&model, params](const Ray& ray) { return img_from_cam(model, params, ray); };
  return seen;
}

}  // namespace fca::consumers::colmap
