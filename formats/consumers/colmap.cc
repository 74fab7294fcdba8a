// SPDX-License-Identifier: BSD-3-Clause
// COLMAP: cameras and rigs of a model folder, as text or binary, and rig_config.json for its rig_configurator. From
// colmap/colmap@5d968cf (4.2.0.dev0, 2026-08-08), src/colmap/scene/ reconstruction_io_text.cc (ReadCamerasText, ReadRigsText),
// reconstruction_io_binary.cc (ReadCamerasBinary, ReadRigsBinary), scene/rig.cc (ReadRigConfig) and sensor/models.h
// (ImgFromCam with check_cheirality of each model). Version 3.8 splits at single blanks and knows the models up to
// THIN_PRISM_FISHEYE. The centre of COLMAP's first pixel is (0.5, 0.5).
#include <rapidjson/document.h>

#include <algorithm>
#include <array>
#include <bit>
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
    ModelRow{"SIMPLE_DIVISION", 1, 1, &division, "4.0"},
    ModelRow{"DIVISION", 2, 1, &division, "4.0"},
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

/// Little endian.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  /// A number of that many bytes; 0, and is_short(), where there are not so many.
  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    short_ = short_ || bytes_.size() < size;
    if (short_) return 0;
    for (std::size_t i = size; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes_[i]);
    bytes_.remove_prefix(size);
    return value;
  }
  double real() { return std::bit_cast<double>(number(sizeof(double))); }
  [[nodiscard]] bool is_short() const { return short_; }
  [[nodiscard]] bool is_at_end() const { return !short_ && bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool short_ = false;
};

class Reader {
 public:
  explicit Reader(ConsumerView& view) : view_(view) {}

  /// ReadCamerasBinary. True if it takes all bytes.
  bool run_binary(std::string_view bytes) {
    Bytes stream(bytes);
    const std::uint64_t count = stream.number(8);
    for (std::uint64_t i = 1; view_.loads() && i <= count; ++i) {
      const auto id = static_cast<std::uint32_t>(stream.number(4));
      const auto number = static_cast<std::int32_t>(stream.number(4));
      const std::uint64_t width = stream.number(8);
      const std::uint64_t height = stream.number(8);
      if (stream.is_short() || width > kLargest || height > kLargest) {
        refuse(Code::kColmapSaysEnds, {i});
        break;
      }
      if (number < 0 || static_cast<std::size_t>(number) >= kRows.size()) {
        refuse(Code::kColmapSaysModelNumber, {i, number});
        break;
      }
      ColmapCamera camera{&kRows.at(static_cast<std::size_t>(number)), {}};
      camera.params.resize(camera.model->focal_lengths + 2 + camera.model->coefficients);
      for (double& value : camera.params) value = stream.real();
      if (stream.is_short()) {
        refuse(Code::kColmapSaysEnds, {i});
        break;
      }
      add(camera, id, {width, height}, static_cast<int>(i));
    }
    if (view_.loads() && view_.cameras.empty()) refuse(Code::kColmapSaysNoCamera, {});
    return view_.loads() && stream.is_at_end();
  }

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
  static constexpr std::uint64_t kLargest = std::numeric_limits<int>::max();

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
    if (!(words >> id >> name >> width >> height) || width > kLargest || height > kLargest)
      return refuse(Code::kColmapSaysLine, {number});
    const auto model = std::ranges::find(kRows, name, &ModelRow::name);
    if (model == kRows.end()) return refuse(Code::kColmapSaysUnknownModel, {number, name.substr(0, 40)});
    ColmapCamera camera{&*model, {}};
    for (double value = 0.0; words >> value;) camera.params.push_back(value);
    const std::size_t wanted = model->focal_lengths + 2 + model->coefficients;
    if (camera.params.size() != wanted)
      return refuse(Code::kColmapSaysParameterCount, {number, camera.params.size(), name, wanted});
    add(camera, id, {width, height}, number);
  }

  /// `number`: of its line, or its own.
  void add(const ColmapCamera& camera, std::uint32_t id, const std::array<std::uint64_t, 2>& size, int number) {
    const ModelRow* model = camera.model;
    if (!ids_.insert(id).second) return refuse(Code::kColmapSaysIdTwice, {number, id});
    if (!model->since.empty() && told_.insert(model->name).second)
      view_.warnings.emplace_back(Code::kColmapSaysNewModel, "", std::vector<Argument>{model->name, model->since});
    ConsumerCamera seen = seen_camera("cam" + std::to_string(view_.cameras.size()), camera);
    seen.width = static_cast<int>(size[0]);
    seen.height = static_cast<int>(size[1]);
    view_.cameras.push_back(std::move(seen));
  }

  ConsumerView& view_;
  std::set<std::uint32_t> ids_;
  std::set<std::string_view> told_;
};

/// ReadRigsText and ReadRigsBinary. Sensors are called as there: "CAMERA 2".
class Rigs {
 public:
  explicit Rigs(ConsumerView& view) : view_(view) {}

  void run_text(std::string_view bytes) {
    std::istringstream lines{std::string(bytes)};
    int number = 0;
    for (std::string line; view_.loads() && std::getline(lines, line);) {
      const std::size_t first = line.find_first_not_of(" \t\r\v\f");
      if (first == std::string::npos || line[first] == '#') continue;
      std::istringstream words(line);
      words.imbue(std::locale::classic());
      if (!read_line(words, ++number)) refuse(Code::kColmapSaysNoRigLine, number);
    }
  }

  /// True if it takes all bytes.
  bool run_binary(std::string_view bytes) {
    Bytes stream(bytes);
    const std::uint64_t count = stream.number(8);
    for (std::uint64_t i = 1; view_.loads() && i <= count; ++i) {
      const auto number = static_cast<int>(i);
      stream.number(4);
      const std::uint64_t sensors = stream.number(4);
      std::string reference;
      for (std::uint64_t k = 0; k < sensors && view_.loads() && !stream.is_short(); ++k) {
        const std::string type = stream.number(4) == 0 ? "CAMERA" : "IMU";
        const std::string name = type + " " + std::to_string(stream.number(4));
        const bool has_pose = k > 0 && stream.number(1) != 0;
        Numbers numbers(has_pose ? 7 : 0);
        for (double& value : numbers) value = stream.real();
        if (!stream.is_short()) add(name, numbers, reference, number);
      }
      if (stream.is_short()) refuse(Code::kColmapSaysEnds, number);
    }
    return view_.loads() && stream.is_at_end();
  }

 private:
  void refuse(Code code, int number) {
    view_.refusals.emplace_back(code, "", std::vector<Argument>{number});
    view_.poses.clear();
  }

  bool read_line(std::istream& words, int number) {
    std::uint32_t id = 0;
    std::uint64_t sensors = 0;
    if (!(words >> id >> sensors)) return false;
    std::string reference;
    for (std::uint64_t k = 0; k < sensors && view_.loads(); ++k) {
      std::string type;
      int has_pose = 0;
      if (!(words >> type >> id) || (type != "CAMERA" && type != "IMU") || (k > 0 && !(words >> has_pose))) return false;
      Numbers numbers(has_pose == 1 ? 7 : 0);
      for (double& value : numbers) words >> value;
      if (!words) return false;
      add(type + " " + std::to_string(id), numbers, reference, number);
    }
    return true;
  }

  /// The first sensor of a rig is its reference.
  void add(const std::string& name, const Numbers& q, std::string& reference, int number) {
    if (reference.empty()) sensors_.clear();
    if (!sensors_.insert(name).second) return refuse(Code::kColmapSaysSensorTwice, number);
    if (reference.empty()) reference = name;
    if (!q.empty()) view_.poses.push_back({name, reference, pose_as_if_unit(q[0], {q[1], q[2], q[3]}, {q[4], q[5], q[6]})});
  }

  ConsumerView& view_;
  std::set<std::string> sensors_;
};

/// Which of the two a program opens it as its path says; here, what it is.
bool holds_rigs(std::string_view bytes) {
  std::istringstream lines{std::string(bytes)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::array<std::string, 3> first;
    words >> first[0] >> first[1] >> first[2];
    if (!first[0].empty() && first[0][0] != '#') return first[2] == "CAMERA" || first[2] == "IMU";
  }
  return false;
}

/// Behind a count of 8 bytes.
bool is_binary(std::string_view bytes) { return bytes.size() >= 8 && bytes.substr(4, 4) == std::string_view("\0\0\0\0", 4); }

void load_binary(std::string_view bytes, ConsumerView& view) {
  ConsumerView as_rigs;
  if (Reader(view).run_binary(bytes) || !Rigs(as_rigs).run_binary(bytes)) return;
  view = as_rigs;
}

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
  } else if (is_binary(bytes)) {
    load_binary(bytes, view);
  } else if (holds_rigs(bytes)) {
    Rigs(view).run_text(bytes);
  } else {
    Reader(view).run(bytes);
  }
  return view;
}

}  // namespace fca::consumers
