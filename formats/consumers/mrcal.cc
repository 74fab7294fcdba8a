// SPDX-License-Identifier: BSD-3-Clause
// mrcal as a consumer of a .cameramodel: mrcal/cameramodel.py (_read_into_self) of Debian's 2.2 and of the newest, and
// opencv.c's formula, which is cv::projectPoints' but for points at z = 0. The two versions differ in the pose: the one demands
// extrinsics, the other rt_cam_ref, or extrinsics, and the same from both.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "../column.h"
#include "about_key.h"
#include "fca/code.h"
#include "opencv_formulas.h"
#include "programs.h"
#include "python_literal.h"

namespace fca::consumers {
namespace {

using python::Kind;
using python::Value;

constexpr std::string_view kProgram = "mrcal";

/// An element of np.array(list, dtype=float), which takes texts of numbers, too.
std::optional<double> as_float(const Value& value) {
  if (value.is_number()) return value.number;
  if (value.kind == Kind::kNone) return std::numeric_limits<double>::quiet_NaN();
  double number = 0.0;
  const char* const end = value.text.data() + value.text.size();
  const auto [stop, error] = std::from_chars(value.text.data(), end, number);
  const bool is_whole = value.kind == Kind::kString && error == std::errc() && stop == end;
  return is_whole ? std::optional(number) : std::nullopt;
}

constexpr std::size_t kCore = 4;  ///< fx fy cx cy

struct Lens {
  std::string_view name;
  std::size_t count;
};
constexpr std::array kLenses = {Lens{"LENSMODEL_PINHOLE", kCore}, Lens{"LENSMODEL_OPENCV4", kCore + 4},
                                Lens{"LENSMODEL_OPENCV5", kCore + 5}, Lens{"LENSMODEL_OPENCV8", kCore + 8},
                                Lens{"LENSMODEL_OPENCV12", kCore + 12}};
constexpr std::array<std::string_view, 5> kOthers = {"LENSMODEL_STEREOGRAPHIC", "LENSMODEL_LONLAT", "LENSMODEL_LATLON",
                                                     "LENSMODEL_CAHVOR", "LENSMODEL_SPLINED_STEREOGRAPHIC_"};

std::string described(const Value& value) {
  constexpr std::size_t kLongest = 40;
  if (value.kind == Kind::kList) return "a list";
  return value.kind == Kind::kDict ? "a dict" : "'" + value.text.substr(0, kLongest) + "'";
}

class Model {
 public:
  Model(const Value& root, ConsumerView& view) : root_(root), view_(view) {}

  void load() {
    std::string lens_key;
    const std::string lens = lens_name(lens_key);
    const auto intrinsics = numbers("intrinsics", std::nullopt);
    const auto size = image_size();
    const auto rt = pose();
    read_region();
    read_inputs();
    if (!view_.loads() || lens.empty() || !intrinsics || !size || !rt) return;
    const auto known = std::find_if(kLenses.begin(), kLenses.end(), [&lens](const Lens& each) { return each.name == lens; });
    if (known == kLenses.end()) {
      const bool is_other =
          std::any_of(kOthers.begin(), kOthers.end(), [&lens](std::string_view begin) { return lens.starts_with(begin); });
      if (is_other) return warn(Code::kMrcalSaysOtherLens, lens_key, {lens});
      return refuse(Code::kProgramSaysUnknownWord, lens_key, {lens, kProgram, column(kLenses, &Lens::name)});
    }
    if (intrinsics->size() != known->count)
      return refuse(Code::kMrcalSaysCoefficientCount, "intrinsics", {intrinsics->size(), lens, known->count});
    add_camera(lens, *intrinsics, *size);
    add_pose(*rt);
  }

 private:
  void refuse(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.refusals.push_back(about_key(code, key, std::move(arguments)));
  }
  void warn(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.warnings.push_back(about_key(code, key, std::move(arguments)));
  }
  void miss(const std::string& key) { refuse(Code::kProgramSaysMissing, key, {kProgram}); }

  /// By today's name; empty with a refusal where there is none. `key`: under which it stands.
  std::string lens_name(std::string& key) {
    for (const char* each : {"lensmodel", "distortion_model", "lens_model"}) {
      const Value* name = root_.find(each);
      if (name == nullptr) continue;
      key = each;
      if (name->kind != Kind::kString || name->text.empty()) {
        refuse(Code::kProgramSaysNoText, key, {kProgram});
        return "";
      }
      std::string lens = name->text;
      constexpr std::string_view kOld = "DISTORTION";
      for (std::size_t at = lens.find(kOld); at != std::string::npos; at = lens.find(kOld))
        lens.replace(at, kOld.size(), "LENSMODEL");
      return lens;
    }
    miss("lensmodel");
    return "";
  }

  std::optional<std::vector<double>> numbers(const std::string& key, std::optional<std::size_t> count) {
    const Value* list = root_.find(key);
    if (list == nullptr) {
      miss(key);
      return std::nullopt;
    }
    std::vector<double> values;
    for (const Value& item : list->items) {
      // Of the pose mrcal asks each for its type.
      const std::optional<double> number = count && !item.is_number() ? std::nullopt : as_float(item);
      if (!number) {
        refuse(Code::kProgramSaysNoNumber, key, {described(item), kProgram});
        return std::nullopt;
      }
      values.push_back(*number);
    }
    if (list->kind == Kind::kList && (!count || values.size() == *count)) return values;
    refuse(Code::kProgramSaysNumberCount, key, {count.value_or(kCore), kProgram});
    return std::nullopt;
  }

  std::optional<std::array<int, 2>> image_size() {
    const std::string key = "imagersize";
    const Value* list = root_.find(key);
    if (list == nullptr) {
      miss(key);
      return std::nullopt;
    }
    const auto is_side = [](const Value& side) {
      return side.is_number() && side.number > 0.0 && side.number == std::floor(side.number) && side.number < 2147483648.0;
    };
    if (list->kind == Kind::kList && list->items.size() == 2 && is_side(list->items[0]) && is_side(list->items[1]))
      return std::array{static_cast<int>(list->items[0].number), static_cast<int>(list->items[1].number)};
    refuse(Code::kMrcalSaysSize, key);
    return std::nullopt;
  }

  std::optional<std::vector<double>> pose() {
    const std::string old_key = "extrinsics";
    const std::string new_key = "rt_cam_ref";
    const bool has_new = root_.find(new_key) != nullptr;
    if (root_.find(old_key) == nullptr && has_new) {
      warn(Code::kMrcalSaysOnlyNewPose, old_key, {new_key});
      return numbers(new_key, 6);
    }
    const auto rt = numbers(old_key, 6);
    if (!rt || !has_new) return rt;
    const auto same = numbers(new_key, 6);
    constexpr double kSame = 1e-9;
    for (std::size_t i = 0; same && i < 6; ++i) {
      if (std::abs((*rt)[i] - (*same)[i]) < kSame) continue;
      refuse(Code::kMrcalSaysPosesDiffer, old_key, {new_key});
      return std::nullopt;
    }
    return same ? rt : std::nullopt;
  }

  void read_region() {
    const std::string key = "valid_intrinsics_region";
    const Value* region = root_.find(key);
    if (region == nullptr || (region->kind == Kind::kList && region->items.empty())) return;
    const auto is_point = [](const Value& point) {
      return point.items.size() == 2 && point.items[0].is_number() && point.items[1].is_number();
    };
    constexpr std::size_t kFewest = 4;
    constexpr double kApart = 1e-6;
    const auto& points = region->items;
    bool good = points.size() >= kFewest && std::all_of(points.begin(), points.end(), is_point);
    for (std::size_t i = 0; good && i < 2; ++i)
      good = std::abs(points.front().items[i].number - points.back().items[i].number) <= kApart;
    if (!good) warn(Code::kMrcalSaysRegion, key);
  }

  void read_inputs() {
    const std::string key = "optimization_inputs";
    const Value* inputs = root_.find(key);
    const std::string number_key =
        root_.find("icam_intrinsics") == nullptr && root_.find("icam_intrinsics_optimization_inputs") != nullptr
            ? "icam_intrinsics_optimization_inputs"
            : "icam_intrinsics";
    const Value* number = root_.find(number_key);
    if (inputs == nullptr) {
      if (number != nullptr) warn(Code::kMrcalSaysNumberWithoutInputs, number_key);
      return;
    }
    if (inputs->kind != Kind::kBytes) refuse(Code::kMrcalSaysNoBytes, key);
    if (number == nullptr) return miss(number_key);
    if (!number->is_int() || number->number < 0.0) refuse(Code::kMrcalSaysNoCameraNumber, number_key);
  }

  void add_camera(const std::string& lens, const std::vector<double>& values, const std::array<int, 2>& size) {
    const opencv::CameraMatrix K = {.fx = values[0], .fy = values[1], .cx = values[2], .cy = values[3]};
    opencv::PinholeCoefficients d{};
    std::copy(values.begin() + kCore, values.end(), d.begin());
    ConsumerCamera camera;
    camera.name = "cam0";
    camera.model = lens;
    camera.width = size[0];
    camera.height = size[1];
    // Points from behind are mirrored without a word; at z = 0 it is not a number.
    camera.project = [K, d](const std::array<double, 3>& ray) -> std::optional<std::array<double, 2>> {
      if (ray[2] == 0.0) return std::nullopt;
      const opencv::Pixel pixel = opencv::project_points(K, d, ray);
      return std::isfinite(pixel[0]) && std::isfinite(pixel[1]) ? std::optional(pixel) : std::nullopt;
    };
    view_.cameras.push_back(std::move(camera));
  }

  void add_pose(const std::vector<double>& rt) {
    ConsumerPose pose = {"cam0", "ref", {}};
    const opencv::Matrix3 R = opencv::rotation_of({rt[0], rt[1], rt[2]});
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) pose.T_a_b.at(4 * row + column) = R.at(3 * row + column);
      pose.T_a_b.at(4 * row + 3) = rt[3 + row];
    }
    pose.T_a_b[15] = 1.0;
    view_.poses.push_back(std::move(pose));
  }

  const Value& root_;
  ConsumerView& view_;
};

}  // namespace

ConsumerView load_mrcal(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  const python::Loaded loaded = python::literal_eval(bytes);
  if (!loaded.error.empty()) {
    view.refusals.emplace_back(Code::kProgramSaysNotParsed, "", std::vector<Argument>{kProgram, loaded.error});
  } else if (loaded.root.kind != Kind::kDict) {
    view.refusals.emplace_back(Code::kProgramSaysNoKeys, "");
  } else {
    Model(loaded.root, view).load();
  }
  return view;
}

}  // namespace fca::consumers
