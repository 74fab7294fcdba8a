// SPDX-License-Identifier: BSD-3-Clause
// VINS-Fusion (HKUST-Aerial-Robotics/VINS-Fusion@be55a937) as a consumer of its camera files: camera_models' CameraFactory.cc,
// PinholeCamera.cc, PinholeFullCamera.cc, CataCamera.cc (MEI), EquidistantCamera.cc (KANNALA_BRANDT) and ScaramuzzaCamera.cc,
// which are camodocal's, through cv::FileStorage. VINS-Mono's are the same but for PINHOLE_FULL.
//
// It checks nothing: a key that is missing is 0, a text or a list where a number belongs the largest double. The factory takes
// a model_type in any case, the parameters of PINHOLE, PINHOLE_FULL, MEI and KANNALA_BRANDT only in capitals, and stay 0
// otherwise. A camera of zeros is refused here: nobody can mean it.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "fca/code.h"
#include "programs.h"
#include "storage.h"

namespace fca::consumers {
namespace {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Projection = std::function<std::optional<Pixel>(const Ray&)>;

constexpr std::string_view kProgram = "VINS";

/// Of sentences that begin with the key.
void refuse(ConsumerView& view, Code code, const std::string& key, std::vector<Argument> arguments = {}) {
  arguments.insert(arguments.begin(), key);
  view.refusals.emplace_back(code, key, std::move(arguments));
}

std::optional<Pixel> finite(const Pixel& pixel) {
  return std::isfinite(pixel[0]) && std::isfinite(pixel[1]) ? std::optional(pixel) : std::nullopt;
}

/// The sections of a file, and sentences about what is not in them.
class Parameters {
 public:
  Parameters(const cv::FileStorage& storage, ConsumerView& view) : storage_(storage), view_(view) {}

  /// static_cast<double>(node); what is not there is said.
  double operator()(const std::string& section, const std::string& key) {
    const cv::FileNode node = storage_[section][key];
    if (node.empty()) {
      refuse(view_, Code::kVinsSaysMissing, section + "/" + key);
    } else if (!storage::is_number(node)) {
      refuse(view_, Code::kVinsSaysNoNumber, section + "/" + key, {storage::description_of(node)});
    }
    return static_cast<double>(node);
  }
  /// Of one that may be missing.
  [[nodiscard]] double otherwise_zero(const std::string& section, const std::string& key) const {
    return static_cast<double>(storage_[section][key]);
  }
  [[nodiscard]] bool has(const std::string& section) const { return storage_[section].isMap(); }

 private:
  const cv::FileStorage& storage_;
  ConsumerView& view_;
};

/// PinholeCamera::distortion and CataCamera::distortion, of a point in the plane.
struct Distortion {
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0;
  [[nodiscard]] Pixel operator()(double x, double y) const {
    if (k1 == 0.0 && k2 == 0.0 && p1 == 0.0 && p2 == 0.0) return {x, y};
    const double xx = x * x;
    const double yy = y * y;
    const double xy = x * y;
    const double rho2 = xx + yy;
    const double radial = k1 * rho2 + k2 * rho2 * rho2;
    return {x + (x * radial + 2.0 * p1 * xy + p2 * (rho2 + 2.0 * xx)),
            y + (y * radial + 2.0 * p2 * xy + p1 * (rho2 + 2.0 * yy))};
  }
};

Distortion read_distortion(Parameters& parameters) {
  Distortion d;
  d.k1 = parameters("distortion_parameters", "k1");
  d.k2 = parameters("distortion_parameters", "k2");
  d.p1 = parameters("distortion_parameters", "p1");
  d.p2 = parameters("distortion_parameters", "p2");
  return d;
}

/// The linear part: two focal lengths and the centre.
struct Linear {
  double fu = 0.0, fv = 0.0, u0 = 0.0, v0 = 0.0;
  [[nodiscard]] Pixel operator()(const Pixel& point) const { return {fu * point[0] + u0, fv * point[1] + v0}; }
};

Linear read_linear(Parameters& parameters, const std::array<const char*, 4>& keys) {
  Linear linear;
  linear.fu = parameters("projection_parameters", keys[0]);
  linear.fv = parameters("projection_parameters", keys[1]);
  linear.u0 = parameters("projection_parameters", keys[2]);
  linear.v0 = parameters("projection_parameters", keys[3]);
  return linear;
}

/// Rays from behind give the pixel of their mirror image.
Projection read_pinhole(Parameters& parameters) {
  const Distortion distortion = read_distortion(parameters);
  const Linear linear = read_linear(parameters, {"fx", "fy", "cx", "cy"});
  return [distortion, linear](const Ray& p) { return finite(linear(distortion(p[0] / p[2], p[1] / p[2]))); };
}

Projection read_pinhole_full(Parameters& parameters, ConsumerCamera& camera, ConsumerView& view) {
  std::array<double, 8> k{};  // k1 .. k6 p1 p2
  const std::array<const char*, 8> keys = {"k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2"};
  for (std::size_t i = 0; i < keys.size(); ++i) k.at(i) = parameters("distortion_parameters", keys.at(i));
  const Linear linear = read_linear(parameters, {"fx", "fy", "cx", "cy"});
  const bool none = k[0] == 0.0 && k[1] == 0.0 && k[6] == 0.0 && k[7] == 0.0;
  if (none && std::any_of(k.begin() + 2, k.begin() + 6, [](double value) { return value != 0.0; })) {
    camera.misread = true;
    view.warnings.emplace_back(Code::kVinsSaysFullOfZeros, "distortion_parameters");
  }
  return [k, linear, none](const Ray& p) {
    const double x = p[0] / p[2];
    const double y = p[1] / p[2];
    if (none) return finite(linear({x, y}));
    const double r2 = x * x + y * y;
    const double r4 = r2 * r2;
    const double r6 = r4 * r2;
    const double up = 1.0 + k[0] * r2 + k[1] * r4 + k[2] * r6;
    const double down = 1.0 / (1.0 + k[3] * r2 + k[4] * r4 + k[5] * r6);
    return finite(linear({x * up * down + k[6] * 2.0 * x * y + k[7] * (r2 + 2.0 * x * x),
                          y * up * down + k[6] * (r2 + 2.0 * y * y) + k[7] * 2.0 * x * y}));
  };
}

Projection read_mei(Parameters& parameters) {
  const double xi = parameters("mirror_parameters", "xi");
  const Distortion distortion = read_distortion(parameters);
  const Linear linear = read_linear(parameters, {"gamma1", "gamma2", "u0", "v0"});
  return [xi, distortion, linear](const Ray& p) {
    const double z = p[2] + xi * std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    return finite(linear(distortion(p[0] / z, p[1] / z)));
  };
}

Projection read_kannala_brandt(Parameters& parameters, ConsumerCamera& camera) {
  std::array<double, 4> k{};
  const std::array<const char*, 4> keys = {"k2", "k3", "k4", "k5"};
  for (std::size_t i = 0; i < keys.size(); ++i) k.at(i) = parameters("projection_parameters", keys.at(i));
  const Linear linear = read_linear(parameters, {"mu", "mv", "u0", "v0"});
  // Near the axis, acos rounds the angle to sqrt(2 eps).
  constexpr double kAcosRounding = 2.2e-8;
  camera.approximation_px = kAcosRounding * std::max(std::abs(linear.fu), std::abs(linear.fv));
  return [k, linear](const Ray& p) {
    const double theta = std::acos(p[2] / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
    const double phi = std::atan2(p[1], p[0]);
    double radius = theta;
    double power = theta;
    for (const double coefficient : k) {
      power *= theta * theta;
      radius += coefficient * power;
    }
    return finite(linear({radius * std::cos(phi), radius * std::sin(phi)}));
  };
}

/// OCAMCamera. x along the columns, z to the front.
struct Ocam {
  std::array<double, 5> poly{};
  std::array<double, 20> inverse{};
  double ac = 0.0, ad = 0.0, ae = 0.0, cx = 0.0, cy = 0.0;

  /// spaceToPlane; on the axis 0 / 0.
  [[nodiscard]] Pixel project(const Ray& p) const {
    const double norm = std::sqrt(p[0] * p[0] + p[1] * p[1]);
    const double theta = std::atan2(-p[2], norm);
    double rho = 0.0;
    double power = 1.0;
    for (const double coefficient : inverse) {
      rho += power * coefficient;
      power *= theta;
    }
    const double scale = 1.0 / norm;
    const double x = p[0] * scale * rho;
    const double y = p[1] * scale * rho;
    return {x * ac + y * ad + cx, x * ae + y + cy};
  }
  [[nodiscard]] double height(double radius) const {
    double z = 0.0;
    double power = 1.0;
    for (const double coefficient : poly) {
      z += power * coefficient;
      power *= radius;
    }
    return -z;
  }
  /// The pixel's point in the lens's own plane.
  [[nodiscard]] Pixel straightened(const Pixel& pixel) const {
    const double scale = 1.0 / (ac - ad * ae);
    const double u = pixel[0] - cx;
    const double v = pixel[1] - cy;
    return {scale * (u - ad * v), scale * (ac * v - ae * u)};
  }
  /// liftProjective: the height is of the straightened point, the ray's x and y are the pixel's.
  [[nodiscard]] Ray unproject(const Pixel& pixel) const {
    const Pixel point = straightened(pixel);
    return {pixel[0] - cx, pixel[1] - cy, height(std::sqrt(point[0] * point[0] + point[1] * point[1]))};
  }
  /// How far projecting is from the inverse of the direct polynomial over the image: the two are separate fits.
  [[nodiscard]] double disagreement(int width, int height_px) const {
    double worst = 0.0;
    double last_angle = -1.0;
    const double farthest = std::hypot(width, height_px);
    for (double radius = 0.125; radius < farthest; radius += 0.5) {
      const double angle = std::atan2(radius, height(radius));
      if (angle <= last_angle) break;  // beyond, two radii have one ray
      last_angle = angle;
      bool inside = false;
      for (int k = 0; k < 8; ++k) {
        const double phi = std::numbers::pi * k / 4.0;
        const double x = radius * std::cos(phi);
        const double y = radius * std::sin(phi);
        const double u = ac * x + ad * y + cx;
        const double v = ae * x + y + cy;
        inside = inside || (u >= 0.0 && v >= 0.0 && u <= width - 1.0 && v <= height_px - 1.0);
      }
      if (!inside) continue;
      const Pixel there = project({radius, 0.0, height(radius)});
      const double off = std::hypot(there[0] - ac * radius - cx, there[1] - ae * radius - cy);
      if (!(off <= worst)) worst = off;
    }
    return worst;
  }
};

Projection read_scaramuzza(Parameters& parameters, ConsumerCamera& camera, ConsumerView& view) {
  Ocam ocam;
  for (std::size_t i = 0; i < ocam.poly.size(); ++i) ocam.poly.at(i) = parameters("poly_parameters", "p" + std::to_string(i));
  for (std::size_t i = 0; i < ocam.inverse.size(); ++i)
    ocam.inverse.at(i) = parameters.otherwise_zero("inv_poly_parameters", "p" + std::to_string(i));
  if (!parameters.has("inv_poly_parameters")) refuse(view, Code::kVinsSaysInverseMissing, "inv_poly_parameters");
  ocam.ac = parameters("affine_parameters", "ac");
  ocam.ad = parameters("affine_parameters", "ad");
  ocam.ae = parameters("affine_parameters", "ae");
  ocam.cx = parameters("affine_parameters", "cx");
  ocam.cy = parameters("affine_parameters", "cy");
  if (ocam.ac - ocam.ad * ocam.ae == 0.0) view.refusals.emplace_back(Code::kVinsSaysAffineSingular, "affine_parameters");
  if (!view.loads()) return {};
  constexpr double kLargestApproximation = 1.0;  // px; beyond it is no approximation but another lens
  constexpr double kBetweenPoints = 1.5;
  const double difference = ocam.disagreement(camera.width, camera.height) * std::max(1.0, 1.0 / ocam.ac);
  camera.approximation_px = difference < kLargestApproximation ? kBetweenPoints * difference : 0.0;
  if (!(difference < 0.1)) {
    view.warnings.emplace_back(Code::kVinsSaysInverseOff, "inv_poly_parameters", std::vector<Argument>{difference});
  }
  if (ocam.ac != 1.0 || ocam.ad != 0.0 || ocam.ae != 0.0) {
    view.warnings.emplace_back(Code::kVinsSaysAffineForgotten, "affine_parameters");
  }
  view.warnings.emplace_back(Code::kVinsSaysNoPixelOnAxis, "model_type");
  camera.unproject = [ocam](const Pixel& pixel) { return std::optional(ocam.unproject(pixel)); };
  camera.unproject_fault = {Code::kRaysWithoutAffine};
  return [ocam](const Ray& ray) { return finite(ocam.project(ray)); };
}

/// boost::iequals
bool same_in_any_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&lower](char x, char y) { return lower(x) == lower(y); });
}

Projection read_model(const std::string& type, Parameters& parameters, ConsumerCamera& camera, ConsumerView& view) {
  if (same_in_any_case(type, "scaramuzza")) return read_scaramuzza(parameters, camera, view);
  for (const char* known : {"PINHOLE", "PINHOLE_FULL", "MEI", "KANNALA_BRANDT"}) {
    if (type == known || !same_in_any_case(type, known)) continue;
    refuse(view, Code::kVinsSaysModelCase, "model_type", {type, known});
    return {};
  }
  if (type == "PINHOLE") return read_pinhole(parameters);
  if (type == "PINHOLE_FULL") return read_pinhole_full(parameters, camera, view);
  if (type == "MEI") return read_mei(parameters);
  if (type == "KANNALA_BRANDT") return read_kannala_brandt(parameters, camera);
  refuse(view, Code::kVinsSaysUnknownModel, "model_type", {storage::one_line(type.substr(0, 80))});
  return {};
}

/// static_cast<int>(node)
int read_size(const cv::FileStorage& storage, const char* key, ConsumerView& view) {
  const cv::FileNode node = storage[key];
  if (storage::is_number(node)) return static_cast<int>(node);
  if (node.empty()) {
    refuse(view, Code::kVinsSaysSizeMissing, key);
  } else {
    refuse(view, Code::kProgramNoNumber, key, {storage::description_of(node)});
  }
  return 0;
}

/// readParameters of parameters.cpp: the main configuration, whose cameras stand in files of their own.
void read_config(const cv::FileStorage& storage, ConsumerView& view) {
  const auto number = [&storage](const char* key) { return static_cast<double>(storage[key]); };
  const int count = static_cast<int>(storage["num_of_cam"]);
  if (count != 1 && count != 2)
    refuse(view, Code::kVinsSaysCameraCount, "num_of_cam", {storage::description_of(storage["num_of_cam"])});
  for (int i = 0; i < std::min(count, 2); ++i) {
    const std::string file = "cam" + std::to_string(i) + "_calib";
    if (!storage[file].isString()) refuse(view, Code::kVinsSaysCameraMissing, file);
    // 2: no prior; the first camera begins at the identity.
    if (i == 0 && static_cast<int>(storage["estimate_extrinsic"]) == 2) continue;
    const std::string key = "body_T_cam" + std::to_string(i);
    if (!storage[key].isMap()) {
      refuse(view, Code::kVinsSaysPoseMissing, key);
      continue;
    }
    const cv::Mat matrix = storage::read_matrix(storage[key]);
    if (matrix.rows != 4 || matrix.cols != 4 || matrix.channels() != 1) {
      refuse(view, Code::kVinsSaysPoseSize, key);
      continue;
    }
    cv::Mat T;
    matrix.convertTo(T, CV_64F);
    ConsumerPose pose{"imu0", "cam" + std::to_string(i), {}};
    for (int k = 0; k < 16; ++k) pose.T_a_b.at(static_cast<std::size_t>(k)) = T.at<double>(k / 4, k % 4);
    view.poses.push_back(std::move(pose));
  }
  for (const char* key : {"image_width", "image_height"}) read_size(storage, key, view);
  std::vector<std::string> needed = {"max_cnt",         "min_dist",           "F_threshold",
                                     "max_solver_time", "max_num_iterations", "keyframe_parallax"};
  if (number("imu") != 0.0) needed.insert(needed.end(), {"acc_n", "gyr_n", "acc_w", "gyr_w", "g_norm"});
  std::erase_if(needed, [&number](const std::string& key) { return number(key.c_str()) != 0.0; });
  if (!needed.empty()) view.warnings.emplace_back(Code::kVinsSaysZero, needed.front(), std::vector<Argument>{needed});
}

void read_camera(const cv::FileStorage& storage, ConsumerView& view) {
  if (storage["model_type"].empty() && !storage["cam0_calib"].empty()) {
    read_config(storage, view);
    return;
  }
  if (storage["model_type"].empty()) {
    refuse(view, Code::kVinsSaysNoModel, "model_type");
    return;
  }
  const cv::FileNode type = storage["model_type"];
  ConsumerCamera camera;
  camera.name = "cam0";
  camera.width = read_size(storage, "image_width", view);
  camera.height = read_size(storage, "image_height", view);
  if (!type.isString()) return refuse(view, Code::kVinsSaysUnknownModel, "model_type", {storage::description_of(type)});
  camera.model = type.string();
  Parameters parameters(storage, view);
  camera.project = read_model(camera.model, parameters, camera, view);
  if (view.loads()) view.cameras.push_back(std::move(camera));
}

}  // namespace

ConsumerView load_vins(std::string_view bytes, const LoadOptions&) {
  return storage::read(bytes, kProgram, storage::reader_of(kProgram), &read_camera);
}

}  // namespace fca::consumers
