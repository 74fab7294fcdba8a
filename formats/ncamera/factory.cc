// SPDX-License-Identifier: BSD-3-Clause
//   cam_model                        PinholeNoDistortion, PinholeRadialTangential, PinholeEquidistant, PinholeAtan
//   cam_width, cam_height            pixels
//   cam_fx, cam_fy, cam_cx, cam_cy   pixels
//   cam_d0 ..                        k1 k2 p1 p2, of which missing ones are 0; k1 k2 k3 k4 of cv::fisheye; w of an FOV lens
//   T_body_cam or T_cam_body         tx ty tz [m], qx qy qz qw
#include "factory.h"

#include "../column.h"
#include "../schema/keys.h"

#include <fca/code.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace fca::ncamera {

using text::Node;

namespace {

constexpr text::Dialect kDialect = text::Dialect::kOpenCv;
constexpr std::string_view kModel = "cam_model";

struct FactoryLens {
  std::string_view name;
  std::string_view model;
  std::span<const ParameterId> coefficients;
  bool may_be_missing = false;
};
constexpr std::array<ParameterId, 4> kRadtan = {"k1", "k2", "p1", "p2"};
constexpr std::array<ParameterId, 4> kEquidistant = {"k1", "k2", "k3", "k4"};
constexpr std::array<ParameterId, 1> kFov = {"w"};
constexpr std::array<FactoryLens, 4> kLenses = {{{"PinholeNoDistortion", "pinhole", {}},
                                                 {"PinholeRadialTangential", "radtan", kRadtan, true},
                                                 {"PinholeEquidistant", "kb4", kEquidistant},
                                                 {"PinholeAtan", "fov", kFov}}};

class FactoryReader {
 public:
  FactoryReader(fields::Reader& reader, Rig& rig) : reader_(reader), rig_(rig) {}

  bool read(const Node& node, Camera camera) {
    const Node* model = reader_.require(node, kModel, camera.name);
    if (model == nullptr) return false;
    const auto* const lens = std::ranges::find(kLenses, model->value, &FactoryLens::name);
    if (lens == kLenses.end()) {
      reader_.say(*model, Code::kTableUnknownWord,
                  {camera.name + " " + std::string(kModel), model->value.substr(0, 40), column(kLenses, &FactoryLens::name)});
      return false;
    }
    camera.model = make_model(lens->model).value();
    bool good = true;
    constexpr std::array<std::string_view, 4> kKeys = {"cam_fx", "cam_fy", "cam_cx", "cam_cy"};
    constexpr std::array<ParameterId, 4> kIds = {"fx", "fy", "cx", "cy"};
    for (std::size_t i = 0; i < kKeys.size(); ++i) good = read_parameter(node, kKeys.at(i), kIds.at(i), camera, true) && good;
    for (std::size_t i = 0; i < lens->coefficients.size(); ++i)
      good = read_parameter(node, "cam_d" + std::to_string(i), lens->coefficients[i], camera, !lens->may_be_missing) && good;
    good = read_size(node, camera) && good && read_pose(node, camera.name);
    rig_.cameras.push_back(std::move(camera));
    return good;
  }

 private:
  /// Both numbers, or none.
  bool read_size(const Node& node, Camera& camera) {
    constexpr std::string_view kWidth = "cam_width";
    constexpr std::string_view kHeight = "cam_height";
    if (reader_.find(node, kWidth) == nullptr && reader_.find(node, kHeight) == nullptr) return true;
    const Node* width = reader_.require(node, kWidth, camera.name);
    const Node* height = reader_.require(node, kHeight, camera.name);
    if (width == nullptr || height == nullptr) return false;
    camera.image_size = reader_.image_size(*width, *height, camera.name + " ");
    return camera.image_size.has_value();
  }

  bool read_parameter(const Node& node, std::string_view key, ParameterId id, Camera& camera, bool required) {
    const Node* number = required ? reader_.require(node, key, camera.name) : reader_.find(node, key);
    if (number == nullptr) return !required;
    return reader_.parameter(*number, camera.name + " " + std::string(key), id, camera.model);
  }

  /// The first of the two keys that is there; none: the program takes the identity, which nobody has stated.
  bool read_pose(const Node& node, const std::string& camera) {
    for (const std::string_view key : {"T_body_cam", "T_cam_body"}) {
      const Node* pose = reader_.find(node, key);
      if (pose == nullptr) continue;
      const std::string what = camera + " " + std::string(key);
      std::array<double, 7> numbers{};
      std::size_t at = 0;
      for (const std::string_view part : {"tx", "ty", "tz", "qx", "qy", "qz", "qw"}) {
        const Node* number = reader_.require(*pose, part, what);
        const std::optional<double> value =
            number != nullptr ? reader_.real(*number, what + " " + std::string(part)) : std::nullopt;
        if (!value) return false;
        numbers.at(at++) = *value;
      }
      const Quaternion q = {numbers[3], numbers[4], numbers[5], numbers[6]};
      const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
      // One that is no rotation's is told so by its matrix.
      const Quaternion unit = std::abs(length - 1.0) < kRoughly ? normalised(q) : q;
      const std::optional<Transform> T = reader_.checked(pose_of(unit, {numbers[0], numbers[1], numbers[2]}), *pose, what);
      if (!T) return false;
      const std::string body(schema::kImu);
      rig_.poses.push_back(key == "T_body_cam" ? PoseEdge{body, camera, *T} : PoseEdge{camera, body, *T});
      rig_.add_frame(body, FrameKind::kImu);
      return true;
    }
    return true;
  }

  static constexpr double kRoughly = 0.05;  ///< Of the length of a quaternion that was printed with few digits.

  fields::Reader& reader_;
  Rig& rig_;
};

/// FAST-LIVO's cameras have the same keys, and other names for their lenses.
bool is_camera(const Node& node) {
  const Node* model = text::find(node, kModel, kDialect);
  return model != nullptr && text::find(node, "cam_fx", kDialect) != nullptr &&
         (model->value.starts_with("Pinhole") && model->value != "Pinhole");
}

}  // namespace

bool is_factory_file(const text::Document& document) {
  return std::ranges::any_of(document.root().entries, [](const text::Entry& entry) { return is_camera(entry.value); });
}

std::optional<Rig> read_factory_file(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics) {
  Rig rig;
  fields::Reader reader(document, kDialect, diagnostics);
  FactoryReader factory(reader, rig);
  bool good = true;
  for (const text::Entry& entry : document.root().entries) {
    if (!is_camera(entry.value) || rig.find_camera(entry.key.value) != nullptr) continue;
    Camera camera;
    camera.name = reader.name(entry.key, "a camera's name");
    camera.image_size = options.image_size;
    good = factory.read(entry.value, std::move(camera)) && good;
    constexpr std::string_view kBase = "T_cam_base";  // no program reads it
    if (const Node* base = text::find(entry.value, kBase, kDialect)) {
      rig.extra_fields.push_back(
          {rig.cameras.empty() ? "" : rig.cameras.back().name, std::string(kBase), fields::value_text(*base)});
    }
  }
  return good ? std::optional(std::move(rig)) : std::nullopt;
}

}  // namespace fca::ncamera
