// SPDX-License-Identifier: BSD-3-Clause
// The two readers that came with the WoodScape dataset (valeoai/WoodScape@597d9dd): scripts/calibration/projection.py
// (read_cam_from_json), and omnidet (data_loader/woodscape_loader.py, losses/inverse_warp_fisheye.py, data/generate_luts.py).
// Both use Python's json.load. RapidJSON stands in for it here, with Python's ways: the last of two equal keys wins at the
// place of the first, NaN and Infinity are numbers, a BOM is an error.
#include <rapidjson/document.h>
#include <rapidjson/error/en.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fca/code.h"
#include "programs.h"

namespace fca::consumers {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Four = std::array<double, 4>;
using Json = rapidjson::Value;

/// A dict: values in the order in which their keys were first seen.
std::vector<std::pair<std::string, const Json*>> items(const Json& object) {
  std::vector<std::pair<std::string, const Json*>> result;
  for (const auto& member : object.GetObject()) {
    const std::string key(member.name.GetString(), member.name.GetStringLength());
    const auto known = std::find_if(result.begin(), result.end(), [&key](const auto& item) { return item.first == key; });
    if (known == result.end()) {
      result.emplace_back(key, &member.value);
    } else {
      known->second = &member.value;
    }
  }
  return result;
}

const Json* find(const Json& object, std::string_view key) {
  const Json* found = nullptr;
  for (const auto& member : object.GetObject()) {
    if (std::string_view(member.name.GetString(), member.name.GetStringLength()) == key) found = &member.value;
  }
  return found;
}

/// True and False are numbers, too, in Python.
std::optional<double> as_number(const Json& value) {
  if (value.IsNumber()) return value.GetDouble();
  if (value.IsBool()) return value.GetBool() ? 1.0 : 0.0;
  return std::nullopt;
}

/// Lists within lists end Python's reader at about 1000 (RecursionError); a calibration has 2.
bool is_nested_too_deep(std::string_view text) {
  constexpr int kPythonsLimit = 900;
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') {
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == '[' || c == '{')) {
      ++depth;
    } else if (!quoted && (c == ']' || c == '}')) {
      --depth;
    }
    if (depth > kPythonsLimit) return true;
  }
  return false;
}

/// json.load, and the objects that both programs look into first.
class File {
 public:
  File(std::string_view bytes, ConsumerView& view) : view_(view) {
    if (bytes.size() > kMaxBytes) {
      refuse(Code::kProgramFileTooLarge);
    } else if (bytes.starts_with("\xEF\xBB\xBF")) {
      refuse(Code::kPythonJsonBom);
    } else if (bytes.find('\0') != std::string_view::npos) {
      refuse(Code::kPythonJsonZeroByte);
    } else if (is_nested_too_deep(bytes)) {
      refuse(Code::kPythonJsonTooDeep);
    } else {
      parse(bytes);
    }
  }

  /// Of the file as a whole.
  void refuse(Code code, std::vector<Argument> arguments = {}) { view_.refusals.emplace_back(code, "", std::move(arguments)); }
  void warn(Code code, std::vector<Argument> arguments = {}) { view_.warnings.emplace_back(code, "", std::move(arguments)); }
  /// Of what stands at `path`, "intrinsic.k1": argument 0, `more` follow.
  void refuse_at(std::string_view path, Code code, std::vector<Argument> more = {}) {
    view_.refusals.push_back(complaint(path, code, std::move(more)));
  }
  void warn_at(std::string_view path, Code code, std::vector<Argument> more = {}) {
    view_.warnings.push_back(complaint(path, code, std::move(more)));
  }

  [[nodiscard]] bool is_object() {
    if (!view_.loads()) return false;
    if (document_.IsObject()) return true;
    refuse(Code::kPythonJsonNoObject);
    return false;
  }
  [[nodiscard]] const Json* root_member(std::string_view key) const { return find(document_, key); }

  /// config['key'], a dict.
  const Json* object(std::string_view key) {
    const Json* found = find(document_, key);
    if (found == nullptr) {
      refuse_at(key, Code::kPythonKeyMissing, {key, std::vector<Message>()});
    } else if (!found->IsObject()) {
      refuse_at(key, Code::kPythonNotAnObject);
      found = nullptr;
    }
    return found;
  }

  /// object['key'], where a number is wanted.
  double number(const Json& object, const std::string& name, std::string_view key) {
    const Json* found = find(object, key);
    const std::string path = name + "." + std::string(key);
    if (found == nullptr) {
      refuse_at(path, Code::kPythonKeyMissing, {key, std::vector<Message>()});
      return 0.0;
    }
    const std::optional<double> value = as_number(*found);
    if (!value) refuse_at(path, Code::kPythonNotANumber);
    return value.value_or(0.0);
  }

  /// object['key'], a list of that many numbers.
  template <std::size_t kCount>
  std::optional<std::array<double, kCount>> numbers(const Json& object, const std::string& name, std::string_view key) {
    const Json* found = find(object, key);
    const std::string path = name + "." + std::string(key);
    if (found == nullptr) {
      refuse_at(path, Code::kPythonKeyMissing, {key, similar(object, key)});
      return std::nullopt;
    }
    std::array<double, kCount> result{};
    bool fits = found->IsArray() && found->Size() == kCount;
    for (std::size_t i = 0; fits && i < kCount; ++i) {
      const std::optional<double> value = as_number((*found)[static_cast<rapidjson::SizeType>(i)]);
      fits = value.has_value();
      result.at(i) = value.value_or(0.0);
    }
    if (fits) return result;
    refuse_at(path, Code::kPythonNotNumbers, {kCount});
    return std::nullopt;
  }

 private:
  static Complaint complaint(std::string_view path, Code code, std::vector<Argument> more) {
    std::string key(path);
    std::replace(key.begin(), key.end(), '.', '/');
    more.insert(more.begin(), path);
    return {code, std::move(key), std::move(more)};
  }

  void parse(std::string_view bytes) {
    constexpr unsigned kPython = rapidjson::kParseFullPrecisionFlag | rapidjson::kParseNanAndInfFlag |
                                 rapidjson::kParseIterativeFlag | rapidjson::kParseValidateEncodingFlag;
    document_.Parse<kPython>(bytes.data(), bytes.size());
    if (!document_.HasParseError()) return;
    refuse(Code::kPythonJsonNotParsed, {document_.GetErrorOffset(), rapidjson::GetParseError_En(document_.GetParseError())});
  }

  /// SynWoodScape writes "translation used in CARLA (CARLA reference)".
  static std::vector<Message> similar(const Json& object, std::string_view key) {
    for (const auto& [name, value] : items(object)) {
      if (name.starts_with(key)) return {{Code::kPythonSimilarKey, {name.substr(0, 80)}}};
    }
    return {};
  }

  ConsumerView& view_;
  rapidjson::Document document_;
};

struct Polynomial {
  Four k{};
  std::array<double, 2> centre{};
  double aspect = 1.0;
};

/// Camera.project_3d_to_2d. The camera's own origin is the one point without a pixel.
std::optional<Pixel> project(const Polynomial& lens, const Ray& ray) {
  const double chi = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1]);
  if (chi == 0.0 && ray[2] == 0.0) return std::nullopt;
  const double theta = std::numbers::pi / 2.0 - std::atan2(ray[2], chi);
  double rho = 0.0;
  for (std::size_t i = 0; i < lens.k.size(); ++i) rho += lens.k.at(i) * std::pow(theta, static_cast<double>(i + 1));
  const double factor = chi != 0.0 ? rho / chi : 0.0;
  const Pixel pixel = {ray[0] * factor + lens.centre[0], ray[1] * factor * lens.aspect + lens.centre[1]};
  if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1])) return std::nullopt;
  return pixel;
}

/// scipy's Rotation.from_quat: scalar last, normalised.
std::array<double, 9> rotation_of(const Four& quaternion) {
  double norm = 0.0;
  for (const double value : quaternion) norm += value * value;
  norm = std::sqrt(norm);
  const double x = quaternion[0] / norm;
  const double y = quaternion[1] / norm;
  const double z = quaternion[2] / norm;
  const double w = quaternion[3] / norm;
  return {x * x - y * y - z * z + w * w, 2.0 * (x * y - z * w),          2.0 * (x * z + y * w),
          2.0 * (x * y + z * w),         -x * x + y * y - z * z + w * w, 2.0 * (y * z - x * w),
          2.0 * (x * z - y * w),         2.0 * (y * z + x * w),          -x * x - y * y + z * z + w * w};
}

/// np.array(size, dtype=int): cut, not rounded.
std::optional<int> as_size(double value) {
  constexpr double kMaxSide = 1 << 20;
  if (!std::isfinite(value) || std::abs(value) > kMaxSide) return std::nullopt;
  return static_cast<int>(value);
}

class ProjectionPy {
 public:
  ProjectionPy(File& file, ConsumerView& view) : file_(file), view_(view) {}

  void run() {
    if (!file_.is_object()) return;
    const Json* intrinsic = file_.object("intrinsic");
    const Json* extrinsic = file_.object("extrinsic");
    if (intrinsic != nullptr) read_intrinsic(*intrinsic);
    if (extrinsic != nullptr) read_extrinsic(*extrinsic);
  }

 private:
  double number(const Json& intrinsic, std::string_view key) { return file_.number(intrinsic, "intrinsic", key); }

  void read_intrinsic(const Json& intrinsic) {
    Polynomial lens;
    lens.k = {number(intrinsic, "k1"), number(intrinsic, "k2"), number(intrinsic, "k3"), number(intrinsic, "k4")};
    const std::optional<int> width = as_size(number(intrinsic, "width"));
    const std::optional<int> height = as_size(number(intrinsic, "height"));
    lens.centre = {number(intrinsic, "cx_offset"), number(intrinsic, "cy_offset")};
    lens.aspect = number(intrinsic, "aspect_ratio");
    if (!width || !height) {
      file_.refuse(Code::kProjectionPySizeNotInt);
      return;
    }
    lens.centre[0] += 0.5 * *width - 0.5;
    lens.centre[1] += 0.5 * *height - 0.5;
    for (const std::string_view key : {"k5", "k6", "k7"}) {
      if (find(intrinsic, key) != nullptr) file_.warn_at("intrinsic." + std::string(key), Code::kProjectionPyIgnores);
    }
    check(intrinsic, lens, *width, *height);
    ConsumerCamera camera;
    camera.name = "cam0";
    camera.width = *width;
    camera.height = *height;
    camera.model = "radial_poly";
    camera.project = [lens](const Ray& ray) { return project(lens, ray); };
    view_.cameras.push_back(std::move(camera));
  }

  /// The reader never looks at "model": forks keep the name and store normalised coefficients.
  void check(const Json& intrinsic, const Polynomial& lens, int width, int height) {
    constexpr double kNoPixels = 10.0;
    if (std::abs(lens.k[0]) < kNoPixels) file_.warn_at("intrinsic.k1", Code::kProjectionPyNormalised);
    const Json* model = find(intrinsic, "model");
    if (model != nullptr && (!model->IsString() || std::string_view(model->GetString()) != "radial_poly"))
      file_.warn_at("intrinsic.model", Code::kProjectionPyOtherModel);
    if (width <= 0 || height <= 0) file_.warn(Code::kProjectionPySizeNotPositive);
  }

  /// T_vehicle_camera.
  void read_extrinsic(const Json& extrinsic) {
    const auto quaternion = file_.numbers<4>(extrinsic, "extrinsic", "quaternion");
    const auto translation = file_.numbers<3>(extrinsic, "extrinsic", "translation");
    if (!quaternion || !translation) return;
    const std::array<double, 9> R = rotation_of(*quaternion);
    if (std::any_of(R.begin(), R.end(), [](double value) { return !std::isfinite(value); })) {
      file_.refuse_at("extrinsic.quaternion", Code::kProjectionPyNoRotation);
      return;
    }
    ConsumerPose pose{"vehicle", "cam0", {}};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t col = 0; col < 3; ++col) pose.T_a_b.at(4 * row + col) = R.at(3 * row + col);
      pose.T_a_b.at(4 * row + 3) = translation->at(row);
    }
    pose.T_a_b.back() = 1.0;
    view_.poses.push_back(pose);
  }

  File& file_;
  ConsumerView& view_;
};

/// omnidet takes list(intrinsic.values()): aspect, cx, cy = [0:3], k1..k4 = [4:8], whatever the keys are, and puts the centre
/// into images of 1280 x 966, without the half pixel. All in float32. Nothing is rescaled here: its images are at that size.
class Omnidet {
 public:
  Omnidet(File& file, ConsumerView& view) : file_(file), view_(view) {}

  void run() {
    if (!file_.is_object()) return;
    const Json* intrinsic = file_.object("intrinsic");
    if (file_.root_member("name") == nullptr) file_.refuse_at("name", Code::kOmnidetNameMissing);
    if (intrinsic == nullptr) return;
    const auto values = items(*intrinsic);
    if (values.size() < kPlaces.size()) {
      file_.refuse_at("intrinsic", Code::kOmnidetTooFewValues, {values.size()});
      return;
    }
    std::array<double, 8> numbers{};
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
      const std::optional<double> value = as_number(*values[i].second);
      if (!value) {
        file_.refuse_at("intrinsic", Code::kOmnidetValueNoNumber, {i, values[i].first, kPlaces.at(i)});
        return;
      }
      numbers.at(i) = *value;
    }
    constexpr std::size_t kWidthPlace = 10;
    if (values.size() != kWidthPlace + 1 || values.back().first != "width")
      file_.warn_at("intrinsic", Code::kOmnidetWidthNotLast);
    add_camera(*intrinsic, numbers, values);
  }

 private:
  static constexpr std::array<std::string_view, 8> kPlaces = {"aspect_ratio", "cx_offset", "cy_offset", "height",
                                                              "k1",           "k2",        "k3",        "k4"};
  static constexpr int kWidth = 1280;
  static constexpr int kHeight = 966;

  void add_camera(const Json& intrinsic, const std::array<double, 8>& numbers,
                  const std::vector<std::pair<std::string, const Json*>>& values) {
    Polynomial lens;
    lens.aspect = rounded(numbers[0]);
    lens.centre = {rounded(rounded(numbers[1]) + kWidth / 2.0), rounded(rounded(numbers[2]) + kHeight / 2.0)};
    for (std::size_t i = 0; i < 4; ++i) lens.k.at(i) = rounded(numbers.at(4 + i));
    ConsumerCamera camera;
    camera.name = "cam0";
    camera.width = kWidth;
    camera.height = kHeight;
    camera.model = "radial_poly";
    camera.misread = true;
    camera.project = [lens](const Ray& ray) -> std::optional<Pixel> {
      const std::optional<Pixel> pixel = project(lens, ray);
      if (!pixel) return std::nullopt;
      return Pixel{rounded((*pixel)[0]), rounded((*pixel)[1])};
    };
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
      if (values[i].first == kPlaces.at(i)) continue;
      file_.warn_at("intrinsic", Code::kOmnidetOtherOrder, {i, values[i].first, kPlaces.at(i)});
      break;
    }
    warn_about_size(intrinsic);
    file_.warn(Code::kOmnidetCentre, {cost(intrinsic, lens)});
    if (lens.aspect != 1.0) file_.warn(Code::kOmnidetAspectRatio);
    view_.cameras.push_back(std::move(camera));
  }

  static double rounded(double value) { return static_cast<double>(static_cast<float>(value)); }

  void warn_about_size(const Json& intrinsic) {
    const Json* width = find(intrinsic, "width");
    const Json* height = find(intrinsic, "height");
    const bool same = width != nullptr && height != nullptr && as_number(*width) == kWidth && as_number(*height) == kHeight;
    if (!same) file_.warn(Code::kOmnidetOtherSize);
  }

  /// Largest distance from what the keys say, over rays to pixels of the image.
  static Message cost(const Json& intrinsic, const Polynomial& theirs) {
    std::array<double, 9> named{};
    constexpr std::array<std::string_view, 9> kKeys = {"aspect_ratio", "cx_offset", "cy_offset", "height", "k1",
                                                       "k2",           "k3",        "k4",        "width"};
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
      const Json* found = find(intrinsic, kKeys.at(i));
      const std::optional<double> value = found == nullptr ? std::nullopt : as_number(*found);
      if (!value) return {Code::kOmnidetNotComparable, {kKeys.at(i)}};
      named.at(i) = *value;
    }
    const Polynomial ours = {
        {named[4], named[5], named[6], named[7]}, {named[1] + 0.5 * named[8] - 0.5, named[2] + 0.5 * named[3] - 0.5}, named[0]};
    constexpr int kSteps = 30;
    double worst = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
      const double theta = std::numbers::pi / 2.0 * i / kSteps;
      for (int j = 0; j < kSteps; ++j) {
        const double phi = 2.0 * std::numbers::pi * j / kSteps;
        const Ray ray = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
        const auto right = project(ours, ray);
        const auto wrong = project(theirs, ray);
        if (!right || !wrong || (*right)[0] < 0.0 || (*right)[1] < 0.0) continue;
        if ((*right)[0] > named[8] - 1.0 || (*right)[1] > named[3] - 1.0) continue;
        worst = std::max(worst, std::hypot((*right)[0] - (*wrong)[0], (*right)[1] - (*wrong)[1]));
      }
    }
    return {Code::kOmnidetCost, {worst}};
  }

  File& file_;
  ConsumerView& view_;
};

template <class Program>
ConsumerView load(std::string_view bytes) {
  ConsumerView view;
  File file(bytes, view);
  Program(file, view).run();
  if (!view.loads()) {
    view.cameras.clear();
    view.poses.clear();
  }
  return view;
}

}  // namespace

ConsumerView load_woodscape(std::string_view bytes, const LoadOptions& /*options*/) { return load<ProjectionPy>(bytes); }

ConsumerView load_woodscape_omnidet(std::string_view bytes, const LoadOptions& /*options*/) { return load<Omnidet>(bytes); }

}  // namespace fca::consumers
