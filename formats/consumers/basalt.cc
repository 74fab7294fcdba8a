// SPDX-License-Identifier: BSD-3-Clause
// Basalt (VladyslavUsenko/basalt-headers: serialization/headers_serialization.h, calibration/calibration.hpp, camera/*.hpp) as
// a consumer of its calibration JSON. cereal reads it with RapidJSON: every key must be there (NVP not found), a double may be
// an int, an int no double (RapidJSON's assertions throw), further keys are skipped, of equal ones the first is found.
//
// The tables of what the program itself computes (oracles/basalt, oracles/tumvi) are met to 1e-9 px.
#include <rapidjson/document.h>
#include <rapidjson/error/en.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "about_key.h"
#include "fca/code.h"
#include "programs.h"
#include "quaternion_pose.h"

namespace fca::consumers {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Json = rapidjson::Value;
using Parameters = std::vector<double>;
using Projection = std::optional<Pixel> (*)(const Parameters&, const Ray&);

constexpr double kEpsilonSqrt = 1e-5;  // Sophus::Constants<double>::epsilonSqrt()

Pixel scaled(const Parameters& p, double x, double y) { return {p[0] * x + p[2], p[1] * y + p[3]}; }

// PinholeCamera::project
std::optional<Pixel> pinhole(const Parameters& p, const Ray& ray) {
  if (ray[2] < kEpsilonSqrt) return std::nullopt;
  return scaled(p, ray[0] / ray[2], ray[1] / ray[2]);
}

/// The bound of ucm, eucm and ds: z > -w d, with w of alpha.
double half_space(double alpha) { return alpha > 0.5 ? (1.0 - alpha) / alpha : alpha / (1.0 - alpha); }

// UnifiedCamera::project
std::optional<Pixel> ucm(const Parameters& p, const Ray& ray) {
  const double alpha = p[4];
  const double rho = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
  if (ray[2] <= -half_space(alpha) * rho) return std::nullopt;
  const double norm = alpha * rho + (1.0 - alpha) * ray[2];
  return scaled(p, ray[0] / norm, ray[1] / norm);
}

// ExtendedUnifiedCamera::project
std::optional<Pixel> eucm(const Parameters& p, const Ray& ray) {
  const double alpha = p[4];
  const double beta = p[5];
  const double rho = std::sqrt(beta * (ray[0] * ray[0] + ray[1] * ray[1]) + ray[2] * ray[2]);
  if (ray[2] <= -half_space(alpha) * rho) return std::nullopt;
  const double norm = alpha * rho + (1.0 - alpha) * ray[2];
  return scaled(p, ray[0] / norm, ray[1] / norm);
}

// DoubleSphereCamera::project
std::optional<Pixel> ds(const Parameters& p, const Ray& ray) {
  const double xi = p[4];
  const double alpha = p[5];
  const double r2 = ray[0] * ray[0] + ray[1] * ray[1];
  const double d1 = std::sqrt(r2 + ray[2] * ray[2]);
  const double w1 = half_space(alpha);
  const double w2 = (w1 + xi) / std::sqrt(2.0 * w1 * xi + xi * xi + 1.0);
  if (ray[2] <= -w2 * d1) return std::nullopt;
  const double k = xi * d1 + ray[2];
  const double norm = alpha * std::sqrt(r2 + k * k) + (1.0 - alpha) * k;
  return scaled(p, ray[0] / norm, ray[1] / norm);
}

// KannalaBrandtCamera4::project
std::optional<Pixel> kb4(const Parameters& p, const Ray& ray) {
  const double r = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1]);
  if (r <= kEpsilonSqrt) {
    if (ray[2] < kEpsilonSqrt) return std::nullopt;
    return scaled(p, ray[0] / ray[2], ray[1] / ray[2]);
  }
  const double theta = std::atan2(r, ray[2]);
  const double t2 = theta * theta;
  const double radius = theta * (1.0 + t2 * (p[4] + t2 * (p[5] + t2 * (p[6] + t2 * p[7]))));
  return scaled(p, radius * ray[0] / r, radius * ray[1] / r);
}

// FovCamera::project
std::optional<Pixel> fov(const Parameters& p, const Ray& ray) {
  const double w = p[4];
  const double r = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1]);
  const double factor = 2.0 * std::tan(w / 2.0);
  if (r <= kEpsilonSqrt) {
    if (ray[2] < kEpsilonSqrt) return std::nullopt;
    const double rd = w > kEpsilonSqrt ? factor / w : 1.0;
    return scaled(p, ray[0] * rd / ray[2], ray[1] * rd / ray[2]);
  }
  if (w <= kEpsilonSqrt) return pinhole(p, ray);
  const double rd = std::atan2(factor * r, ray[2]) / (r * w);
  return scaled(p, ray[0] * rd, ray[1] * rd);
}

// PinholeRadtan8Camera::project; the last parameter is rpmax.
std::optional<Pixel> radtan8(const Parameters& p, const Ray& ray) {
  if (ray[2] < kEpsilonSqrt) return std::nullopt;
  const double x = ray[0] / ray[2];
  const double y = ray[1] / ray[2];
  const double r2 = x * x + y * y;
  const double limit = p[12];
  if (limit > 0.0 && r2 > limit * limit) return std::nullopt;
  const double factor = (1.0 + r2 * (p[4] + r2 * (p[5] + r2 * p[8]))) / (1.0 + r2 * (p[9] + r2 * (p[10] + r2 * p[11])));
  return scaled(p, x * factor + 2.0 * p[6] * x * y + p[7] * (r2 + 2.0 * x * x),
                y * factor + 2.0 * p[7] * x * y + p[6] * (r2 + 2.0 * y * y));
}

struct CameraType {
  Projection project;
  std::vector<const char*> parameters;
};

const std::map<std::string, CameraType>& camera_types() {
  static const std::map<std::string, CameraType> kTypes = {
      {"pinhole", {pinhole, {"fx", "fy", "cx", "cy"}}},
      {"ucm", {ucm, {"fx", "fy", "cx", "cy", "alpha"}}},
      {"eucm", {eucm, {"fx", "fy", "cx", "cy", "alpha", "beta"}}},
      {"ds", {ds, {"fx", "fy", "cx", "cy", "xi", "alpha"}}},
      {"kb4", {kb4, {"fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4"}}},
      {"fov", {fov, {"fx", "fy", "cx", "cy", "w"}}},
      {"pinhole-radtan8", {radtan8, {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "rpmax"}}},
  };
  return kTypes;
}

std::optional<Pixel> of_unit_length(Projection project, const Parameters& parameters, const Ray& ray) {
  const double length = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
  if (!(length > 0.0)) return std::nullopt;
  const std::optional<Pixel> pixel = project(parameters, {ray[0] / length, ray[1] / length, ray[2] / length});
  if (!pixel || !std::isfinite((*pixel)[0]) || !std::isfinite((*pixel)[1])) return std::nullopt;
  return pixel;
}

/// cereal's JSONInputArchive, with sentences in place of exceptions.
class Archive {
 public:
  Archive(std::string_view bytes, ConsumerView& view) : view_(view) {
    if (bytes.size() > kMaxBytes) {
      refuse(Code::kProgramFileTooLarge);
      return;
    }
    constexpr unsigned kCereal = rapidjson::kParseFullPrecisionFlag | rapidjson::kParseNanAndInfFlag |
                                 rapidjson::kParseIterativeFlag | rapidjson::kParseValidateEncodingFlag;
    document_.Parse<kCereal>(bytes.data(), bytes.size());
    if (!document_.HasParseError()) return;
    view_.refusals.emplace_back(
        Code::kBasaltSaysNotParsed, "",
        std::vector<Argument>{document_.GetErrorOffset(), rapidjson::GetParseError_En(document_.GetParseError())});
  }

  /// Of the file as a whole.
  void refuse(Code code) { view_.refusals.emplace_back(code, ""); }
  /// Of sentences that begin with the key.
  void refuse(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.refusals.push_back(about_key(code, key, std::move(arguments)));
  }

  const Json* root() {
    if (!view_.loads()) return nullptr;
    if (!document_.IsObject()) refuse(Code::kBasaltSaysFileNoObject);
    return document_.IsObject() ? object(document_, "", "value0") : nullptr;
  }

  const Json* find(const Json& owner, const std::string& name, const char* key) {
    const auto member = owner.FindMember(key);
    if (member != owner.MemberEnd()) return &member->value;
    refuse(Code::kBasaltSaysMissing, path(name, key));
    return nullptr;
  }

  const Json* object(const Json& owner, const std::string& name, const char* key) {
    const Json* found = find(owner, name, key);
    if (found == nullptr || found->IsObject()) return found;
    refuse(Code::kBasaltSaysNoObject, path(name, key));
    return nullptr;
  }

  /// A std::vector: any length.
  const Json* list(const Json& owner, const std::string& name, const char* key) {
    const Json* found = find(owner, name, key);
    if (found == nullptr || found->IsArray()) return found;
    refuse(Code::kBasaltSaysNoList, path(name, key));
    return nullptr;
  }

  double number(const Json& owner, const std::string& name, const char* key) {
    const Json* found = find(owner, name, key);
    if (found == nullptr) return 0.0;
    if (!found->IsNumber()) refuse(Code::kBasaltSaysNoNumber, path(name, key));
    return found->IsNumber() ? found->GetDouble() : 0.0;
  }

  /// An Eigen vector of fixed length.
  std::vector<double> vector(const Json& owner, const std::string& name, const char* key, std::size_t count) {
    const Json* found = find(owner, name, key);
    std::vector<double> values;
    if (found == nullptr) return values;
    if (found->IsNumber()) {
      refuse(Code::kBasaltSaysOneNumber, path(name, key), {count});
      return values;
    }
    bool fits = found->IsArray() && found->Size() == count;
    for (std::size_t i = 0; fits && i < count; ++i) {
      const Json& item = (*found)[static_cast<rapidjson::SizeType>(i)];
      fits = item.IsNumber();
      if (fits) values.push_back(item.GetDouble());
    }
    if (fits) return values;
    refuse(Code::kBasaltSaysListLength, path(name, key), {count});
    return {};
  }

 private:
  static std::string path(const std::string& name, const char* key) { return name.empty() ? key : name + "/" + key; }

  ConsumerView& view_;
  rapidjson::Document document_;
};

class Calibration {
 public:
  Calibration(Archive& archive, ConsumerView& view) : archive_(archive), view_(view) {}

  void run() {
    const Json* value = archive_.root();
    if (value == nullptr) return;
    read_poses(*value);
    read_cameras(*value);
    archive_.vector(*value, "value0", "calib_accel_bias", 9);
    archive_.vector(*value, "value0", "calib_gyro_bias", 12);
    archive_.list(*value, "value0", "vignette");
    read_imu(*value);
    read_time_offset(*value);
    if (view_.poses.size() < view_.cameras.size() && view_.loads()) archive_.refuse(Code::kBasaltSaysFewerItems, "T_imu_cam");
  }

 private:
  void read_poses(const Json& value) {
    const Json* list = archive_.list(value, "value0", "T_imu_cam");
    if (list == nullptr) return;
    for (rapidjson::SizeType i = 0; i < list->Size(); ++i) {
      const std::string name = "T_imu_cam/" + std::to_string(i);
      if (!(*list)[i].IsObject()) {
        archive_.refuse(Code::kBasaltSaysNoObject, name);
        continue;
      }
      std::array<double, 7> p{};
      constexpr std::array<const char*, 7> kKeys = {"px", "py", "pz", "qx", "qy", "qz", "qw"};
      for (std::size_t k = 0; k < p.size(); ++k) p.at(k) = archive_.number((*list)[i], name, kKeys.at(k));
      add_pose(p, i);
    }
  }

  /// Eigen's Quaternion::toRotationMatrix, which takes its length for 1: cereal writes past Sophus' normalising constructor.
  void add_pose(const std::array<double, 7>& p, rapidjson::SizeType index) {
    const double length = std::sqrt(p[3] * p[3] + p[4] * p[4] + p[5] * p[5] + p[6] * p[6]);
    constexpr double kPrinted = 1e-6;
    if (!(std::abs(length - 1.0) <= kPrinted)) {
      const std::string name = "T_imu_cam/" + std::to_string(index);
      view_.warnings.emplace_back(Code::kBasaltSaysQuaternionLength, name, std::vector<Argument>{name});
    }
    view_.poses.push_back(
        {"imu0", "cam" + std::to_string(index), pose_as_if_unit(p[6], {p[3], p[4], p[5]}, {p[0], p[1], p[2]})});
  }

  void read_cameras(const Json& value) {
    const Json* lenses = archive_.list(value, "value0", "intrinsics");
    const Json* sizes = archive_.list(value, "value0", "resolution");
    if (lenses == nullptr || sizes == nullptr) return;
    if (lenses->Empty()) archive_.refuse(Code::kBasaltSaysNoCamera, "intrinsics");
    if (sizes->Size() < lenses->Size()) {
      archive_.refuse(Code::kBasaltSaysFewerItems, "resolution");
      return;
    }
    for (rapidjson::SizeType i = 0; i < lenses->Size(); ++i) {
      ConsumerCamera camera;
      camera.name = "cam" + std::to_string(i);
      if (read_size((*sizes)[i], camera) && read_lens((*lenses)[i], camera)) view_.cameras.push_back(std::move(camera));
    }
  }

  /// Eigen::Vector2i
  bool read_size(const Json& size, ConsumerCamera& camera) {
    if (!size.IsArray() || size.Size() != 2 || !size[0].IsInt() || !size[1].IsInt()) {
      archive_.refuse(Code::kBasaltSaysSizeNoInts, camera.name);
      return false;
    }
    camera.width = size[0].GetInt();
    camera.height = size[1].GetInt();
    return true;
  }

  bool read_lens(const Json& lens, ConsumerCamera& camera) {
    if (!lens.IsObject()) {
      archive_.refuse(Code::kBasaltSaysNoObject, camera.name);
      return false;
    }
    const Json* type = archive_.find(lens, camera.name, "camera_type");
    if (type == nullptr) return false;
    const auto known = type->IsString() ? camera_types().find(type->GetString()) : camera_types().end();
    if (known == camera_types().end()) {
      archive_.refuse(Code::kBasaltSaysUnknownType, camera.name + "/camera_type");
      return false;
    }
    const Json* values = archive_.object(lens, camera.name, "intrinsics");
    if (values == nullptr) return false;
    const std::size_t refusals = view_.refusals.size();
    Parameters parameters;
    for (const char* key : known->second.parameters) parameters.push_back(archive_.number(*values, camera.name, key));
    if (view_.refusals.size() != refusals) return false;
    camera.model = known->first;
    camera.project = [project = known->second.project, parameters](const Ray& ray) {
      return of_unit_length(project, parameters, ray);
    };
    return true;
  }

  void read_imu(const Json& value) {
    ConsumerImu& imu = view_.imu.emplace();
    imu.rate_hz = archive_.number(value, "value0", "imu_update_rate");
    const auto noise = [&](const char* key) -> std::optional<double> {
      const std::vector<double> axes = archive_.vector(value, "value0", key, 3);
      if (axes.size() != 3 || axes[0] != axes[1] || axes[0] != axes[2]) return std::nullopt;
      return axes[0];
    };
    imu.accelerometer_noise_density = noise("accel_noise_std");
    imu.gyroscope_noise_density = noise("gyro_noise_std");
    imu.accelerometer_random_walk = noise("accel_bias_std");
    imu.gyroscope_random_walk = noise("gyro_bias_std");
  }

  /// Added to the images' time stamps (vio_estimator.cpp: t_ns += calib.cam_time_offset_ns), of all cameras alike; told of the
  /// first.
  void read_time_offset(const Json& value) {
    const Json* offset = archive_.find(value, "value0", "cam_time_offset_ns");
    if (offset == nullptr) return;
    if (!offset->IsInt64()) {
      archive_.refuse(Code::kBasaltSaysTimeOffsetNoInt, "cam_time_offset_ns");
      return;
    }
    if (!view_.cameras.empty()) view_.cameras.front().time_offset_s = static_cast<double>(offset->GetInt64()) * 1e-9;
  }

  Archive& archive_;
  ConsumerView& view_;
};

}  // namespace

ConsumerView load_basalt(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  Archive archive(bytes, view);
  Calibration(archive, view).run();
  if (!view.loads()) {
    view.cameras.clear();
    view.poses.clear();
    view.imu.reset();
  }
  return view;
}

}  // namespace fca::consumers
