// SPDX-License-Identifier: BSD-3-Clause
// COLMAP: cameras.txt of a model folder, and rig_config.json for its rig_configurator. From colmap/colmap@5d968cf (4.2.0.dev0,
// 2026-08-08), src/colmap/scene/ reconstruction_io_text.cc (ReadCamerasText), scene/rig.cc (ReadRigConfig) and sensor/models.h
// (ImgFromCam with check_cheirality of each model). Version 3.8 splits at single blanks and knows the models up to
// THIN_PRISM_FISHEYE. The centre of COLMAP's first pixel is (0.5, 0.5).
#include <rapidjson/document.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <locale>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "fca/code.h"
#include "programs.h"
#include "quaternion_pose.h"

namespace fca::consumers {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Numbers = std::vector<double>;

/// A point of the image plane before the focal lengths; `c`: the coefficients.
using Bend = Pixel (*)(const Numbers& c, double u, double v);

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

struct ModelRow {
  std::string_view name;
  std::size_t focal_lengths;
  std::size_t coefficients;
  Bend bend;  ///< Null: EUCM, and what is not computed here.
  std::string_view since = {};
};

constexpr std::array kRows = {
    ModelRow{"SIMPLE_PINHOLE", 1, 0, &keep},
    ModelRow{"PINHOLE", 2, 0, &keep},
    ModelRow{"SIMPLE_RADIAL", 1, 1, &radial},
    ModelRow{"RADIAL", 1, 2, &radial},
    ModelRow{"OPENCV", 2, 4, &brown},
    ModelRow{"OPENCV_FISHEYE", 2, 4, &fisheye},
    ModelRow{"FULL_OPENCV", 2, 8, &brown},
    ModelRow{"FOV", 2, 1, &fov},
    ModelRow{"SIMPLE_RADIAL_FISHEYE", 1, 1, &fisheye},
    ModelRow{"RADIAL_FISHEYE", 1, 2, &fisheye},
    ModelRow{"THIN_PRISM_FISHEYE", 2, 8, nullptr},
    ModelRow{"RAD_TAN_THIN_PRISM_FISHEYE", 2, 12, nullptr, "3.11"},
    ModelRow{"SIMPLE_DIVISION", 1, 1, nullptr, "4.0"},
    ModelRow{"DIVISION", 2, 1, nullptr, "4.0"},
    ModelRow{"SIMPLE_FISHEYE", 1, 0, &fisheye, "4.0"},
    ModelRow{"FISHEYE", 2, 0, &fisheye, "4.0"},
    ModelRow{"EUCM", 2, 2, nullptr, "4.1"},
    ModelRow{"EQUIRECTANGULAR", 0, 0, nullptr, "4.1"},
};

struct ColmapCamera {
  const ModelRow* model = nullptr;
  Numbers params;
};

std::optional<Pixel> img_from_cam(const ColmapCamera& camera, const Ray& ray) {
  const auto [u, v, w] = ray;
  const Numbers& p = camera.params;
  const std::size_t focal = camera.model->focal_lengths;
  const Numbers c(p.begin() + static_cast<std::ptrdiff_t>(focal) + 2, p.end());
  if (!(w >= kEpsilon)) return std::nullopt;
  Pixel point{};
  if (camera.model->name == "EUCM") {
    const double rho2 = c[1] * (u * u + v * v) + w * w;
    if (rho2 < 0.0) return std::nullopt;
    const double denominator = c[0] * std::sqrt(rho2) + (1.0 - c[0]) * w;
    if (!(denominator >= kEpsilon)) return std::nullopt;
    point = {u / denominator, v / denominator};
  } else if (camera.model->bend != nullptr) {
    point = camera.model->bend(c, u / w, v / w);
  } else {
    return std::nullopt;
  }
  constexpr double kCentre = 0.5;
  return Pixel{p[0] * point[0] + p[focal] - kCentre, p[focal - 1] * point[1] + p[focal + 1] - kCentre};
}

/// A camera with that lens, as it projects.
ConsumerCamera seen_camera(std::string name, const ColmapCamera& camera) {
  ConsumerCamera seen;
  seen.name = std::move(name);
  seen.model = camera.model->name;
  if (seen.model == "FOV")
    seen.approximation_px = std::max(camera.params[0], camera.params[1]) * fov_series_error(camera.params[4]);
  seen.project = [camera](const Ray& ray) { return img_from_cam(camera, ray); };
  return seen;
}

class Reader {
 public:
  explicit Reader(ConsumerView& view) : view_(view) {}

  void run(std::string_view bytes) {
    std::istringstream lines{std::string(bytes)};
    int number = 0;
    for (std::string line; view_.loads() && std::getline(lines, line);) {
      ++number;
      constexpr std::string_view kBlanks = " \t\r\v\f";
      const std::size_t first = line.find_first_not_of(kBlanks);
      if (first != std::string::npos && line[first] != '#') read_line(line, number);
    }
    if (view_.loads() && view_.cameras.empty()) refuse(Code::kColmapSaysNoCamera, {});
  }

 private:
  void refuse(Code code, std::vector<Argument> arguments) {
    view_.refusals.emplace_back(code, "", std::move(arguments));
    view_.cameras.clear();
  }

  void read_line(const std::string& line, int number) {
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    std::uint32_t id = 0;
    std::string name;
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    constexpr std::uint64_t kLargest = std::numeric_limits<int>::max();
    if (!(words >> id >> name >> width >> height) || width > kLargest || height > kLargest)
      return refuse(Code::kColmapSaysLine, {number});
    const auto model = std::ranges::find(kRows, name, &ModelRow::name);
    if (model == kRows.end()) return refuse(Code::kColmapSaysUnknownModel, {number, name.substr(0, 40)});
    ColmapCamera camera{&*model, {}};
    for (double value = 0.0; words >> value;) camera.params.push_back(value);
    const std::size_t wanted = model->focal_lengths + 2 + model->coefficients;
    if (camera.params.size() != wanted)
      return refuse(Code::kColmapSaysParameterCount, {number, camera.params.size(), name, wanted});
    if (!ids_.insert(id).second) return refuse(Code::kColmapSaysIdTwice, {number, id});
    if (!model->since.empty() && told_.insert(model->name).second)
      view_.warnings.emplace_back(Code::kColmapSaysNewModel, "", std::vector<Argument>{model->name, model->since});
    ConsumerCamera seen = seen_camera("cam" + std::to_string(view_.cameras.size()), camera);
    seen.width = static_cast<int>(width);
    seen.height = static_cast<int>(height);
    view_.cameras.push_back(std::move(seen));
  }

  ConsumerView& view_;
  std::set<std::uint32_t> ids_;
  std::set<std::string_view> told_;
};

/// ReadRigConfig through boost::property_tree: keys in any order, further ones ignored.
class RigConfig {
 public:
  explicit RigConfig(ConsumerView& view) : view_(view) {}

  void run(std::string_view bytes) {
    rapidjson::Document document;
    document.Parse<rapidjson::kParseFullPrecisionFlag | rapidjson::kParseIterativeFlag>(bytes.data(), bytes.size());
    if (document.HasParseError() || !document.IsArray()) return refuse(Code::kColmapSaysNoRig);
    for (const Json& rig : document.GetArray()) {
      const Json* cameras = rig.IsObject() ? member(rig, "cameras") : nullptr;
      if (cameras == nullptr || !cameras->IsArray()) return refuse(Code::kColmapSaysNoRig);
      read_rig(*cameras);
      if (!view_.loads()) return;
    }
  }

 private:
  using Json = rapidjson::Value;

  static const Json* member(const Json& object, const char* key) {
    const auto found = object.FindMember(key);
    return found == object.MemberEnd() ? nullptr : &found->value;
  }

  static Numbers numbers_in(const Json* list) {
    Numbers numbers;
    if (list == nullptr || !list->IsArray()) return numbers;
    for (const Json& item : list->GetArray()) {
      if (item.IsNumber()) numbers.push_back(item.GetDouble());
      if (item.IsString()) numbers.push_back(std::strtod(item.GetString(), nullptr));
    }
    return numbers;
  }

  /// As boost::property_tree reads a bool: numbers and words alike.
  static bool is_true(const Json* value) {
    if (value == nullptr) return false;
    if (value->IsString()) return std::string_view(value->GetString()) == "true" || std::string_view(value->GetString()) == "1";
    return value->IsBool() ? value->GetBool() : value->IsInt() && value->GetInt() == 1;
  }

  /// "cam0" of the prefix "rig/cam0/"
  static std::string name_of(std::string prefix) {
    while (prefix.ends_with('/')) prefix.pop_back();
    return prefix.substr(prefix.rfind('/') + 1);
  }

  void refuse(Code code, std::vector<Argument> arguments = {}) {
    view_.refusals.emplace_back(code, "", std::move(arguments));
    view_.cameras.clear();
    view_.poses.clear();
  }

  /// The values under two keys that count together; nulls, with a warning where one alone is there.
  std::array<const Json*, 2> both(const Json& camera, const char* first, const char* second) {
    const std::array<const Json*, 2> found = {member(camera, first), member(camera, second)};
    if (found[0] != nullptr && found[1] != nullptr) return found;
    if (found[0] != found[1]) {
      const std::vector<Argument> which =
          found[0] != nullptr ? std::vector<Argument>{first, second} : std::vector<Argument>{second, first};
      view_.warnings.emplace_back(Code::kColmapSaysHalf, "", which);
    }
    return {nullptr, nullptr};
  }

  void read_rig(const Json& cameras) {
    std::size_t references = 0;
    std::string reference;
    for (const Json& camera : cameras.GetArray()) {
      const Json* prefix = camera.IsObject() ? member(camera, "image_prefix") : nullptr;
      if (prefix == nullptr || !prefix->IsString()) return refuse(Code::kColmapSaysNoPrefix);
      if (!is_true(member(camera, "ref_sensor"))) continue;
      ++references;
      reference = name_of(prefix->GetString());
    }
    if (references != 1) return refuse(Code::kColmapSaysReferences, {references});
    for (const Json& camera : cameras.GetArray()) {
      const std::string name = name_of(member(camera, "image_prefix")->GetString());
      const auto [rotation, translation] = both(camera, "cam_from_rig_rotation", "cam_from_rig_translation");
      const Numbers q = numbers_in(rotation);
      const Numbers t = numbers_in(translation);
      if (rotation != nullptr && name == reference) return refuse(Code::kColmapSaysReferencePose);
      if (q.size() == 4 && t.size() == 3)
        view_.poses.push_back({name, reference, pose_as_if_unit(q[0], {q[1], q[2], q[3]}, {t[0], t[1], t[2]})});
      read_lens(camera, name);
      if (!view_.loads()) return;
    }
  }

  void read_lens(const Json& camera, const std::string& name) {
    const auto [model_name, params] = both(camera, "camera_model_name", "camera_params");
    if (model_name == nullptr || !model_name->IsString()) return;
    const auto model = std::ranges::find(kRows, std::string_view(model_name->GetString()), &ModelRow::name);
    if (model == kRows.end()) return refuse(Code::kColmapSaysUnknownModel, {0, model_name->GetString()});
    const ColmapCamera lens{&*model, numbers_in(params)};
    if (lens.params.size() == model->focal_lengths + 2 + model->coefficients) view_.cameras.push_back(seen_camera(name, lens));
  }

  ConsumerView& view_;
};

}  // namespace

ConsumerView load_colmap(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  if (bytes.empty() || bytes.size() > kMaxBytes) {
    view.refusals.emplace_back(bytes.empty() ? Code::kProgramFileEmpty : Code::kProgramFileTooLarge, "");
    return view;
  }
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes[first] == '[') {
    RigConfig(view).run(bytes);
  } else {
    Reader(view).run(bytes);
  }
  return view;
}

}  // namespace fca::consumers
