// SPDX-License-Identifier: BSD-3-Clause
// maplab (ethz-asl/maplab, aslam_cv2: camera-factory.cc, camera.cc, ncamera.cc, sensor.cc; map-structure/sensors: imu.cc) as a
// consumer of an ncamera and of a list of sensors with one, through yaml-cpp. A file without distortion has none; ids are 32
// hexadecimal digits, and made up where there are none; principal points are greater than 0; an FOV lens ("fisheye") has a
// parameter from 0.5 to 1.5. Rays from behind a pinhole are told to be so, those of a unified projection are valid as far as it
// goes.
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "ncamera_yaml.h"
#include "opencv_formulas.h"
#include "programs.h"

namespace fca::consumers {
namespace {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Numbers = std::vector<double>;

constexpr double kSmall = 1e-5;  ///< r^2 of an FOV lens below which the program takes its derivative at the centre.

/// On the plane where distortion bends.
Pixel bent(const std::string& distortion, const Numbers& d, double x, double y) {
  const opencv::CameraMatrix identity;
  if (distortion == "radial-tangential") return opencv::project_points(identity, {d[0], d[1], d[2], d[3]}, {x, y, 1.0});
  if (distortion == "equidistant") return opencv::fisheye_project_points(identity, {d[0], d[1], d[2], d[3]}, {x, y, 1.0});
  if (distortion != "fisheye") return {x, y};
  const double w = d[0];
  const double r2 = x * x + y * y;
  const double tangent = ncamera::fov_tangent(w);
  const double r = std::sqrt(r2);
  const double factor = w * w < kSmall ? 1.0 : r2 < kSmall ? tangent / w : std::atan(tangent * r) / (r * w);
  return {factor * x, factor * y};
}

/// A list of numbers that maplab takes: `count` of them.
bool are_taken(ncamera::File& file, const Numbers& numbers, std::size_t count, const std::string& path) {
  if (numbers.size() != count) file.refuse(Code::kProgramSaysNumberCount, path + "/data", {count});
  return numbers.size() == count;
}

bool is_taken(ncamera::File& file, double value, double lowest, double highest, const std::string& path) {
  if (value >= lowest && value <= highest) return true;
  file.complain(Code::kProgramSaysOutOfRange, path, {value, file.program(), lowest, highest});
  return false;
}

struct Distortion {
  std::string type = "none";
  Numbers numbers;
};

std::optional<Distortion> read_distortion(const YAML::Node& node, const std::string& path, ncamera::File& file) {
  if (!node["distortion"] || node["distortion"].IsNull()) return Distortion{};
  const YAML::Node distortion = node["distortion"];
  const auto type = file.word(distortion, "type", path + "/type");
  const YAML::Node parameters = file.require(distortion, "parameters", path + "/parameters");
  const auto numbers = parameters.IsDefined() ? file.matrix(parameters, path + "/parameters", 0, 1) : std::nullopt;
  if (!type || !numbers) return std::nullopt;
  const std::size_t count = *type == "none" ? 0 : *type == "fisheye" ? 1 : 4;
  if (count == 4 && *type != "radial-tangential" && *type != "equidistant") {
    file.complain(Code::kProgramSaysUnknownWord, path + "/type",
                  {*type, file.program(), std::vector<std::string>{"none", "equidistant", "fisheye", "radial-tangential"}});
    return std::nullopt;
  }
  if (!are_taken(file, *numbers, count, path + "/parameters")) return std::nullopt;
  constexpr double kNarrowest = 0.5;
  constexpr double kWidest = 1.5;
  constexpr double kNone = 1e-16;
  if (count == 1 && std::abs((*numbers)[0]) >= kNone &&
      !is_taken(file, (*numbers)[0], kNarrowest, kWidest, path + "/parameters/data/0"))
    return std::nullopt;
  return Distortion{*type, *numbers};
}

std::optional<ConsumerCamera> read_camera(const YAML::Node& node, const std::string& path, ncamera::File& file) {
  const auto type = file.word(node, "type", path + "/type");
  const auto distortion = read_distortion(node, path + "/distortion", file);
  const auto width = file.number(node, "image_width", path + "/image_width");
  const auto height = file.number(node, "image_height", path + "/image_height");
  const YAML::Node intrinsics = file.require(node, "intrinsics", path + "/intrinsics");
  const auto k = intrinsics.IsDefined() ? file.matrix(intrinsics, path + "/intrinsics", 0, 1) : std::nullopt;
  if (!type || !distortion || !width || !height || !k) return std::nullopt;
  const bool unified = *type == "unified-projection";
  if (!unified && *type != "pinhole") {
    file.complain(Code::kProgramSaysUnknownWord, path + "/type",
                  {*type, file.program(), std::vector<std::string>{"pinhole", "unified-projection", "camera-3d-lidar"}});
    return std::nullopt;
  }
  const std::size_t first = unified ? 1 : 0;
  if (!are_taken(file, *k, first + 4, path + "/intrinsics")) return std::nullopt;
  bool good = true;
  for (std::size_t i = 0; i < k->size(); ++i) {
    const double lowest = i < first ? 0.0 : std::nextafter(0.0, 1.0);
    good = is_taken(file, (*k)[i], lowest, HUGE_VAL, path + "/intrinsics/data/" + std::to_string(i)) && good;
  }
  if (!good) return std::nullopt;
  ConsumerCamera camera;
  camera.width = static_cast<int>(*width);
  camera.height = static_cast<int>(*height);
  camera.model = *type + ", " + distortion->type;
  if (distortion->type == "fisheye") {
    // atan(t) = t - t^3 / 3 + ...
    const double w = distortion->numbers[0];
    const double most = std::pow(ncamera::fov_tangent(w) * std::sqrt(kSmall), 3.0) / (3.0 * w);
    camera.approximation_px = std::max((*k)[first], (*k)[first + 1]) * most;
  }
  camera.project = [k = *k, distortion = *distortion, unified, first](const Ray& ray) -> std::optional<Pixel> {
    const double xi = unified ? k[0] : 0.0;
    const double d = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
    const double edge = xi <= 1.0 ? xi : 1.0 / xi;
    if (unified ? !(ray[2] > -edge * d) : !(ray[2] > 0.0)) return std::nullopt;
    const double depth = unified ? ray[2] + xi * d : ray[2];
    const Pixel plane = bent(distortion.type, distortion.numbers, ray[0] / depth, ray[1] / depth);
    return Pixel{k[first] * plane[0] + k[first + 2], k[first + 1] * plane[1] + k[first + 3]};
  };
  return camera;
}

/// Ids are hexadecimal digits, and each is one sensor's.
class Ids {
 public:
  void check(const YAML::Node& sensor, const std::string& path, ncamera::File& file) {
    if (!sensor.IsMap() || !sensor["id"]) return;
    const std::string id = sensor["id"].IsScalar() ? sensor["id"].Scalar() : "";
    bool good = id.size() == 32;
    for (const char c : id) good = good && std::isxdigit(static_cast<unsigned char>(c)) != 0;
    if (!good) {
      file.refuse(Code::kProgramSaysNoId, path + "/id", {id});
    } else if (!seen_.insert(id).second) {
      file.refuse(Code::kProgramSaysSameId, path + "/id", {id});
    }
  }

 private:
  std::set<std::string> seen_;
};

/// T_a_c of T_a_b and T_b_c.
Numbers product(const Numbers& a, const Numbers& b) {
  Numbers result(16, 0.0);
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t k = 0; k < 4; ++k) result[4 * row + column] += a[4 * row + k] * b[4 * k + column];
    }
  }
  return result;
}

Numbers inverse_of(const Numbers& T) {
  Numbers inverse(16, 0.0);
  inverse[15] = 1.0;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      inverse[4 * row + column] = T[4 * column + row];
      inverse[4 * row + 3] -= T[4 * column + row] * T[4 * column + 3];
    }
  }
  return inverse;
}

/// T_B_C, or the inverse of T_C_B.
std::optional<Numbers> read_pose(const YAML::Node& entry, const std::string& path, ncamera::File& file) {
  if (!entry.IsMap() || entry["T_B_C"] || !entry["T_C_B"]) {
    const YAML::Node pose = file.require(entry, "T_B_C", path + "/T_B_C");
    return pose.IsDefined() ? file.matrix(pose, path + "/T_B_C", 4, 4) : std::nullopt;
  }
  const auto T = file.matrix(entry["T_C_B"], path + "/T_C_B", 4, 4);
  if (!T) return std::nullopt;
  return inverse_of(*T);
}

/// How the list of extrinsics says that a sensor sits in its base.
struct Extrinsic {
  std::string base;
  Numbers T_base_sensor;
};

std::optional<Extrinsic> extrinsic_of(const YAML::Node& root, const std::string& id, ncamera::File& file) {
  const YAML::Node list = root["extrinsics"];
  for (std::size_t i = 0; list && list.IsSequence() && i < list.size(); ++i) {
    const YAML::Node entry = list[i];
    if (!entry.IsMap() || !entry["sensor_id"] || entry["sensor_id"].Scalar() != id) continue;
    const std::string path = "extrinsics/" + std::to_string(i);
    const auto base = file.word(entry, "base_sensor_id", path + "/base_sensor_id");
    const YAML::Node pose = file.require(entry, "T_B_S", path + "/T_B_S");
    const auto matrix = pose.IsDefined() ? file.matrix(pose, path + "/T_B_S", 4, 4) : std::nullopt;
    return base && matrix ? std::optional(Extrinsic{*base, *matrix}) : std::nullopt;
  }
  return std::nullopt;
}

/// The poses that the NCAMERA specifies, in the IMU.
void place_in_imu(const YAML::Node& root, const std::string& ncamera_id, const std::string& imu_id, ncamera::File& file) {
  const std::optional<Extrinsic> body = extrinsic_of(root, ncamera_id, file);
  if (!body) return;
  Numbers T_imu_body = body->T_base_sensor;
  if (body->base != imu_id) {
    const std::optional<Extrinsic> imu = extrinsic_of(root, imu_id, file);
    if (!imu || imu->base != body->base) return;
    T_imu_body = product(inverse_of(imu->T_base_sensor), T_imu_body);
  }
  for (ConsumerPose& pose : file.view().poses) {
    const Numbers placed = product(T_imu_body, Numbers(pose.T_a_b.begin(), pose.T_a_b.end()));
    std::copy(placed.begin(), placed.end(), pose.T_a_b.begin());
  }
}

void read_ncamera(const YAML::Node& node, const std::string& prefix, Ids& ids, ncamera::File& file) {
  ids.check(node, prefix.empty() ? "" : prefix.substr(0, prefix.size() - 1), file);
  const YAML::Node cameras = file.require(node, "cameras", prefix + "cameras");
  for (std::size_t i = 0; cameras.IsDefined() && cameras.IsSequence() && i < cameras.size(); ++i) {
    const std::string path = prefix + "cameras/" + std::to_string(i);
    const YAML::Node entry = cameras[i];
    const YAML::Node camera_node = file.require(entry, "camera", path + "/camera");
    if (camera_node.IsDefined()) ids.check(camera_node, path + "/camera", file);
    std::optional<ConsumerCamera> camera =
        camera_node.IsDefined() ? read_camera(camera_node, path + "/camera", file) : std::nullopt;
    const auto pose = read_pose(entry, path, file);
    if (!camera || !pose) continue;
    camera->name = "cam" + std::to_string(file.view().cameras.size());
    file.view().poses.push_back(ncamera::pose_in_imu(camera->name, *pose));
    file.view().cameras.push_back(*std::move(camera));
  }
}

void read_imu(const YAML::Node& node, const std::string& path, ncamera::File& file) {
  const YAML::Node sigmas = file.require(node, "sigmas", path + "/sigmas");
  for (const char* key : {"saturation_accel_max_mps2", "saturation_gyro_max_radps", "gravity_magnitude_mps2"})
    file.number(node, key, path + "/" + key);
  if (!sigmas.IsDefined()) return;
  const auto sigma = [&](const char* key) { return file.number(sigmas, key, path + "/sigmas/" + key); };
  ConsumerImu& imu = file.view().imu.emplace();
  imu.gyroscope_noise_density = sigma("gyro_noise_density");
  imu.gyroscope_random_walk = sigma("gyro_bias_random_walk_noise_density");
  imu.accelerometer_noise_density = sigma("acc_noise_density");
  imu.accelerometer_random_walk = sigma("acc_bias_random_walk_noise_density");
}

void read_file(const YAML::Node& root, ncamera::File& file) {
  Ids ids;
  if (!root["sensors"]) return read_ncamera(root, "", ids, file);
  const YAML::Node sensors = root["sensors"];
  std::string ncamera_id;
  std::string imu_id;
  for (std::size_t i = 0; sensors.IsSequence() && i < sensors.size(); ++i) {
    const std::string path = "sensors/" + std::to_string(i);
    const auto type = file.word(sensors[i], "sensor_type", path + "/sensor_type");
    if (type == "NCAMERA") {
      read_ncamera(sensors[i], path + "/", ids, file);
    } else if (type) {
      ids.check(sensors[i], path, file);
      if (type == "IMU") read_imu(sensors[i], path, file);
    }
    const bool named = type && sensors[i]["id"] && sensors[i]["id"].IsScalar();
    if (named && type == "NCAMERA") ncamera_id = sensors[i]["id"].Scalar();
    if (named && type == "IMU" && imu_id.empty()) imu_id = sensors[i]["id"].Scalar();
  }
  if (!ncamera_id.empty() && !imu_id.empty()) place_in_imu(root, ncamera_id, imu_id, file);
}

}  // namespace

ConsumerView load_maplab(std::string_view bytes, const LoadOptions& /*options*/) {
  return ncamera::read(bytes, "maplab", &read_file);
}

}  // namespace fca::consumers
