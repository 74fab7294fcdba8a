// SPDX-License-Identifier: BSD-3-Clause
// SVO (uzh-rpg/rpg_svo_pro_open@372ab39: vikit_cameras' camera_yaml_serialization.cpp and ncamera_yaml_serialization.cpp,
// imu_handler.cpp) as a consumer of an ncamera, through yaml-cpp. What it cannot read leaves a null pointer, which it uses. It
// reads T_B_C alone, and of the names of lenses pinhole and omni. Rays from behind a pinhole give the pixel of their mirror
// image. Near its axis an FOV lens ("fisheye") is left undistorted. An omni lens projects by its inverse polynomial.
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "ncamera_yaml.h"
#include "opencv_formulas.h"
#include "programs.h"

namespace fca::consumers {
namespace {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Numbers = std::vector<double>;

constexpr double kNearAxis = 1e-3;  ///< Of an FOV lens, on the plane z = 1.

std::optional<Pixel> on_plane(const std::string& distortion, const Numbers& d, const Ray& ray) {
  if (ray[2] == 0.0) return std::nullopt;
  const double x = ray[0] / ray[2];
  const double y = ray[1] / ray[2];
  const opencv::CameraMatrix identity;
  if (distortion == "radial-tangential") return opencv::project_points(identity, {d[0], d[1], d[2], d[3]}, {x, y, 1.0});
  if (distortion == "equidistant") return opencv::fisheye_project_points(identity, {d[0], d[1], d[2], d[3]}, {x, y, 1.0});
  if (distortion != "fisheye") return Pixel{x, y};
  const double r = std::hypot(x, y);
  const double factor = r < kNearAxis ? 1.0 : std::atan(r * 2.0 * std::tan(0.5 * d[0])) / (d[0] * r);
  return Pixel{factor * x, factor * y};
}

/// Five steps of a fixed point iteration from pixel to ray.
Ray from_plane(const std::string& distortion, const Numbers& d, double x0, double y0) {
  constexpr int kSteps = 5;
  if (distortion == "equidistant") {
    const double bent = std::hypot(x0, y0);
    double theta = bent;
    for (int i = 0; i < kSteps; ++i) {
      const double t = theta * theta;
      theta = bent / (1.0 + t * (d[0] + t * (d[1] + t * (d[2] + t * d[3]))));
    }
    const double scale = bent > 0.0 ? std::tan(theta) / bent : 1.0;
    return {x0 * scale, y0 * scale, 1.0};
  }
  double x = x0;
  double y = y0;
  for (int i = 0; i < kSteps; ++i) {
    const double r2 = x * x + y * y;
    const double inverse = 1.0 / (1.0 + (d[0] + d[1] * r2) * r2);
    const double dx = 2.0 * d[2] * x * y + d[3] * (r2 + 2.0 * x * x);
    const double dy = 2.0 * d[3] * x * y + d[2] * (r2 + 2.0 * y * y);
    x = (x0 - dx) * inverse;
    y = (y0 - dy) * inverse;
  }
  return {x, y, 1.0};
}

void set_pinhole(ConsumerCamera& camera, const std::string& distortion, const Numbers& k, const Numbers& d) {
  camera.project = [distortion, k, d](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> plane = on_plane(distortion, d, ray);
    if (!plane) return std::nullopt;
    return Pixel{k[0] * (*plane)[0] + k[2], k[1] * (*plane)[1] + k[3]};
  };
  if (distortion == "fisheye")
    camera.approximation_px = kNearAxis * std::max(k[0], k[1]) * std::abs(ncamera::fov_tangent(d[0]) / d[0] - 1.0);
  if (distortion != "radial-tangential" && distortion != "equidistant") return;
  camera.unproject = [distortion, k, d](const Pixel& pixel) -> std::optional<Ray> {
    return from_plane(distortion, d, (pixel[0] - k[2]) / k[0], (pixel[1] - k[3]) / k[1]);
  };
  camera.unproject_fault = {Code::kRaysInFiveOwnSteps};
}

/// 24 numbers: the polynomial of five, the centre, c, d and e, the inverse polynomial of twelve, and a mask.
class Omni {
 public:
  explicit Omni(Numbers k) : k_(std::move(k)) {}

  [[nodiscard]] std::optional<Pixel> project(const Ray& ray) const {
    const double norm = std::hypot(ray[0], ray[1]);
    if (norm == 0.0) return std::nullopt;  // it divides zero by zero
    const double theta = std::atan(-ray[2] / norm);
    double rho = 0.0;
    for (std::size_t i = kInverseCount; i > 0; --i) rho = rho * theta + k_[kInverse + i - 1];
    return affine(ray[0] / norm * rho, ray[1] / norm * rho);
  }

  /// Between both polynomials, in pixels, as far as the image's corners, and as the angle grows with the radius.
  [[nodiscard]] double disagreement(int width, int height) const {
    constexpr int kSteps = 400;
    double farthest = 0.0;
    for (const double u : {0.0, width - 1.0}) {
      for (const double v : {0.0, height - 1.0})
        farthest = std::max(farthest, std::hypot(u - k_[kCentre], v - k_[kCentre + 1]));
    }
    double worst = 0.0;
    double angle = 0.0;
    for (int i = 1; i <= kSteps; ++i) {
      const double rho = farthest * i / kSteps;
      const double z = -(k_[0] + rho * (k_[1] + rho * (k_[2] + rho * (k_[3] + rho * k_[4]))));
      const double grown = std::atan2(rho, z);
      if (!(grown > angle)) break;
      angle = grown;
      const Pixel right = affine(rho, 0.0);
      const std::optional<Pixel> there = project({rho, 0.0, z});
      if (there) worst = std::max(worst, std::hypot((*there)[0] - right[0], (*there)[1] - right[1]));
    }
    return worst;
  }

 private:
  static constexpr std::size_t kCentre = 5;
  static constexpr std::size_t kAffine = 7;
  static constexpr std::size_t kInverse = 10;
  static constexpr std::size_t kInverseCount = 12;

  [[nodiscard]] Pixel affine(double x, double y) const {
    return {x + k_[kAffine + 2] * y + k_[kCentre], k_[kAffine + 1] * x + k_[kAffine] * y + k_[kCentre + 1]};
  }

  Numbers k_;
};

void set_omni(ConsumerCamera& camera, const Numbers& k, ConsumerView& view) {
  constexpr double kLargestApproximation = 2.0;  // px; beyond it is no approximation but another lens
  constexpr double kBetweenPoints = 1.5;
  constexpr double kNoticeable = 0.1;
  const Omni omni(k);
  const double difference = omni.disagreement(camera.width, camera.height);
  camera.approximation_px = difference < kLargestApproximation ? kBetweenPoints * difference : 0.0;
  if (!(difference < kNoticeable)) view.warnings.emplace_back(Code::kOcamInverseFarOff, "", std::vector<Argument>{difference});
  camera.model = "omni";
  camera.project = [omni](const Ray& ray) { return omni.project(ray); };
}

/// `path`: of the camera, empty or with its slash.
std::optional<ConsumerCamera> read_camera(const YAML::Node& node, const std::string& path, ncamera::File& file) {
  const YAML::Node bending = file.require(node, "distortion", path + "distortion");
  if (!bending.IsDefined()) return std::nullopt;
  const auto distortion = file.word(bending, "type", path + "distortion/type");
  const YAML::Node parameters = file.require(bending, "parameters", path + "distortion/parameters");
  const auto d = parameters.IsDefined() ? file.matrix(parameters, path + "distortion/parameters", 0, 1) : std::nullopt;
  const auto type = file.word(node, "type", path + "type");
  const auto width = file.number(node, "image_width", path + "image_width");
  const auto height = file.number(node, "image_height", path + "image_height");
  const YAML::Node intrinsics = file.require(node, "intrinsics", path + "intrinsics");
  const auto k = intrinsics.IsDefined() ? file.matrix(intrinsics, path + "intrinsics", 0, 1) : std::nullopt;
  if (!distortion || !d || !type || !width || !height || !k) return std::nullopt;
  ConsumerCamera camera;
  camera.width = static_cast<int>(*width);
  camera.height = static_cast<int>(*height);
  camera.model = *type + ", " + *distortion;
  const auto has = [&](const Numbers& numbers, std::size_t count, const std::string& key) {
    if (numbers.size() != count) file.refuse(Code::kProgramSaysNumberCount, path + key + "/data", {count});
    return numbers.size() == count;
  };
  if (*type == "omni") {
    constexpr std::size_t kCount = 24;
    if (!has(*k, kCount, "intrinsics")) return std::nullopt;
    set_omni(camera, *k, file.view());
    return camera;
  }
  if (*type != "pinhole") {
    file.complain(Code::kProgramSaysUnknownWord, path + "type",
                  {*type, file.program(), std::vector<std::string>{"pinhole", "omni"}});
    return std::nullopt;
  }
  const std::size_t count = *distortion == "none" ? 0 : *distortion == "fisheye" ? 1 : 4;
  if (count == 4 && *distortion != "radial-tangential" && *distortion != "equidistant") {
    file.complain(
        Code::kProgramSaysUnknownWord, path + "distortion/type",
        {*distortion, file.program(), std::vector<std::string>{"none", "radial-tangential", "equidistant", "fisheye"}});
    return std::nullopt;
  }
  if (!has(*k, 4, "intrinsics") || (count > 0 && !has(*d, count, "distortion/parameters"))) return std::nullopt;
  set_pinhole(camera, *distortion, *k, *d);
  return camera;
}

std::optional<double> read_imu(const YAML::Node& root, ncamera::File& file) {
  if (!root["imu_params"]) return std::nullopt;
  const YAML::Node node = root["imu_params"];
  const auto number = [&](const char* key) { return file.number(node, key, std::string("imu_params/") + key); };
  const std::optional<double> delay = number("delay_imu_cam");
  for (const char* key : {"max_imu_delta_t", "acc_max", "omega_max", "g"}) number(key);
  ConsumerImu& imu = file.view().imu.emplace();
  imu.gyroscope_noise_density = number("sigma_omega_c");
  imu.accelerometer_noise_density = number("sigma_acc_c");
  imu.gyroscope_random_walk = number("sigma_omega_bias_c");
  imu.accelerometer_random_walk = number("sigma_acc_bias_c");
  imu.rate_hz = number("imu_rate");
  return delay;
}

void read_file(const YAML::Node& root, ncamera::File& file) {
  file.word(root, "label", "label");
  const std::optional<double> delay = read_imu(root, file);
  const YAML::Node cameras = file.require(root, "cameras", "cameras");
  for (std::size_t i = 0; cameras.IsDefined() && cameras.IsSequence() && i < cameras.size(); ++i) {
    const std::string path = "cameras/" + std::to_string(i);
    const YAML::Node entry = cameras[i];
    const YAML::Node node = file.require(entry, "camera", path + "/camera");
    const YAML::Node pose = file.require(entry, "T_B_C", path + "/T_B_C");
    std::optional<ConsumerCamera> camera = node.IsDefined() ? read_camera(node, path + "/camera/", file) : std::nullopt;
    const auto matrix = pose.IsDefined() ? file.matrix(pose, path + "/T_B_C", 4, 4) : std::nullopt;
    if (!camera || !matrix) continue;
    camera->name = "cam" + std::to_string(i);
    // One for all: others are told where the file is written.
    if (delay && i == 0) camera->time_offset_s = *delay == 0.0 ? 0.0 : -*delay;
    file.view().poses.push_back(ncamera::pose_in_imu(camera->name, *matrix));
    file.view().cameras.push_back(*std::move(camera));
  }
  if (cameras.IsDefined() && (!cameras.IsSequence() || cameras.size() == 0)) file.refuse(Code::kProgramSaysNoText, "cameras");
}

}  // namespace

ConsumerView load_svo(std::string_view bytes, const LoadOptions& /*options*/) {
  return ncamera::read(bytes, "SVO", &read_file);
}

}  // namespace fca::consumers
