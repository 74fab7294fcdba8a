// SPDX-License-Identifier: BSD-3-Clause
#include "basalt.h"
#include "layout.h"

#include "../fields.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/limits.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fca::basalt {

using text::Node;

namespace {

constexpr std::size_t kLongestWord = 40;  ///< Of the file, in a message.

class CalibrationReader {
 public:
  CalibrationReader(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics)
      : reader_(document, kDialect, diagnostics), options_(options) {}

  std::optional<Rig> run() {
    const Node* value = reader_.require(reader_.document().root(), "value0", "a Basalt calibration");
    if (value == nullptr) return std::nullopt;
    if (!value->is_mapping()) {
      reader_.say(*value, Code::kBasaltNoObject, {"value0"});
      return std::nullopt;
    }
    reader_.warn_of_duplicates(*value);
    warn_of_missing(*value);
    Rig rig;
    const bool good = read_cameras(*value, rig);
    if (!read_imu(*value, rig) || !read_time_offset(*value, rig) || !good) return std::nullopt;
    keep_unread(*value, rig);
    reader_.warn_of_misspelt();
    return rig;
  }

 private:
  /// What only Basalt itself cannot do without; of the cameras an error is said.
  void warn_of_missing(const Node& value) {
    SourceRange where = reader_.document().range(value);
    where.length = 1;
    std::vector<std::string> missing;
    for (const std::string_view key : kRequired) {
      if (key != "intrinsics" && reader_.find(value, key) == nullptr) missing.emplace_back(key);
    }
    if (!missing.empty()) reader_.diagnostics().add(Code::kBasaltMissingKeys, {missing}, where);
  }

  /// The list under a key with an item for each of `count` cameras; null, with an error if it is something else.
  const Node* list(const Node& value, std::string_view key, std::size_t count, bool& good) {
    const Node* node = reader_.find(value, key);
    if (node == nullptr) return nullptr;
    if (node->is_sequence() && node->items.size() == count) return node;
    if (node->is_sequence()) {
      reader_.say(*node, Code::kBasaltItemCount, {key, node->items.size(), count});
    } else {
      reader_.say(*node, Code::kBasaltNoList, {key, count});
    }
    good = false;
    return nullptr;
  }

  bool read_cameras(const Node& value, Rig& rig) {
    const Node* intrinsics = reader_.require(value, "intrinsics", "value0");
    if (intrinsics == nullptr) return false;
    if (!intrinsics->is_sequence() || intrinsics->items.empty()) {
      reader_.say(*intrinsics, Code::kBasaltNoCameraList, {"intrinsics"});
      return false;
    }
    bool good = true;
    const std::size_t count = intrinsics->items.size();
    const Node* sizes = list(value, "resolution", count, good);
    const Node* poses = list(value, "T_imu_cam", count, good);
    const Node* vignettes = reader_.find(value, kVignette);
    for (std::size_t i = 0; i < count; ++i) {
      Camera camera;
      camera.name = camera_name(i);
      camera.image_size = options_.image_size;
      good = read_lens(intrinsics->items[i], camera, rig) && good;
      if (sizes != nullptr) good = read_size(sizes->items[i], camera) && good;
      if (poses != nullptr) good = read_pose(poses->items[i], camera.name, rig) && good;
      if (vignettes != nullptr && i < vignettes->items.size())
        rig.extra_fields.push_back({camera.name, std::string(kVignette), fields::value_text(vignettes->items[i])});
      rig.cameras.push_back(std::move(camera));
    }
    return good;
  }

  bool read_lens(const Node& node, Camera& camera, Rig& rig) {
    if (!node.is_mapping()) {
      reader_.say(node, Code::kBasaltNoObject, {camera.name});
      return false;
    }
    const Node* type = reader_.require(node, "camera_type", camera.name);
    const Node* parameters = reader_.require(node, "intrinsics", camera.name);
    if (type == nullptr || parameters == nullptr) return false;
    const std::optional<CameraModel> model = make_model(model_of(type->value));
    if (!model) {
      reader_.say(*type, Code::kBasaltUnknownModel, {camera.name, type->value.substr(0, kLongestWord)});
      return false;
    }
    if (!parameters->is_mapping()) {
      reader_.say(*parameters, Code::kBasaltNoObject, {camera.name + " intrinsics"});
      return false;
    }
    camera.model = *model;
    bool good = true;
    std::set<std::string_view> known = {kMaxRadius};
    for (const Parameter& parameter : model_info(camera.model).parameters) {
      known.insert(parameter.name);
      const Node* number = reader_.require(*parameters, parameter.name, camera.name + " intrinsics");
      good = number != nullptr && reader_.parameter(*number, camera.name, ParameterId(parameter), camera.model) && good;
    }
    if (const Node* radius = reader_.find(*parameters, kMaxRadius); radius != nullptr && text::parse_real(radius->value) > 0.0)
      rig.extra_fields.push_back({camera.name, std::string(kMaxRadius), radius->value});
    for (const text::Entry& entry : parameters->entries) {
      if (known.contains(entry.key.value)) continue;
      reader_.say(entry.key, Code::kBasaltUnknownParameter,
                  {camera.name, entry.key.value.substr(0, kLongestWord), type->value});
    }
    return good;
  }

  bool read_size(const Node& node, Camera& camera) {
    if (!node.is_sequence() || node.items.size() != 2) {
      reader_.say(node, Code::kBasaltNoSize, {camera.name});
      return false;
    }
    camera.image_size = reader_.image_size(node.items[0], node.items[1], camera.name + " resolution ");
    return camera.image_size.has_value();
  }

  bool read_pose(const Node& node, const std::string& name, Rig& rig) {
    const std::string what = name + " T_imu_cam";
    if (!node.is_mapping()) {
      reader_.say(node, Code::kBasaltNoPose, {what});
      return false;
    }
    std::array<double, 7> numbers{};
    constexpr std::array<std::string_view, 7> kKeys = {"px", "py", "pz", "qx", "qy", "qz", "qw"};
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
      const Node* number = reader_.require(node, kKeys.at(i), what);
      const std::optional<double> value =
          number != nullptr ? reader_.real(*number, what + " " + std::string(kKeys.at(i))) : std::nullopt;
      if (!value) return false;
      numbers.at(i) = *value;
    }
    const Quaternion q = {numbers[3], numbers[4], numbers[5], numbers[6]};
    const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    constexpr double kFarthest = 0.05;
    constexpr double kPrinted = 1e-3;
    if (!(std::abs(norm - 1.0) <= kPrinted)) {
      const bool near = std::abs(norm - 1.0) <= kFarthest;
      reader_.say(near ? Severity::kWarning : Severity::kError, *reader_.find(node, "qx"),
                  norm > 0.0 ? Code::kBasaltQuaternionLength : Code::kBasaltQuaternionZero, {what, norm});
      if (!near) return false;
    }
    const std::optional<Transform> T = reader_.checked(pose_of(normalised(q), {numbers[0], numbers[1], numbers[2]}),
                                                       {*reader_.find(node, "qx"), what}, {*first_too_long(node), what});
    if (!T) return false;
    rig.poses.push_back({std::string(kImu), name, *T});
    rig.add_frame(kImu, FrameKind::kImu);
    return true;
  }

  /// The coordinate that is beyond what a rig may state; px where none is.
  const Node* first_too_long(const Node& pose) {
    for (const std::string_view key : {"px", "py", "pz"}) {
      const Node* node = reader_.find(pose, key);
      if (std::abs(text::parse_real(node->value).value_or(0.0)) > kLongestDistance) return node;
    }
    return reader_.find(pose, "px");
  }

  bool read_imu(const Node& value, Rig& rig) {
    Imu imu;
    imu.name = kImu;
    bool good = true;
    bool any = false;
    for (const Noise& noise : kNoises) {
      const Node* node = reader_.find(value, noise.key);
      if (node == nullptr) continue;
      any = true;
      good = read_noise(*node, noise, imu, rig) && good;
    }
    if (const Node* rate = reader_.find(value, kRate)) {
      any = true;
      imu.rate_hz = reader_.positive(*rate, kRate);
      good = good && imu.rate_hz;
    }
    if (any) rig.imus.push_back(imu);
    return read_biases(value, rig) && good;
  }

  /// One number for every axis, or (before 2020) one for all. A Rig has one: of axes that differ none is taken.
  bool read_noise(const Node& node, const Noise& noise, Imu& imu, Rig& rig) {
    if (node.is_scalar()) {
      imu.*noise.member = reader_.positive(node, noise.key);
      return (imu.*noise.member).has_value();
    }
    if (!reader_.reals(node, 3, noise.key)) return false;
    std::vector<double> axes;
    for (const Node& item : node.items) {
      const std::optional<double> axis = reader_.positive(item, noise.key);
      if (!axis) return false;
      axes.push_back(*axis);
    }
    if (axes[0] == axes[1] && axes[0] == axes[2]) {
      imu.*noise.member = axes[0];
    } else {
      rig.extra_fields.push_back({std::string(kImu), std::string(noise.key), fields::value_text(node)});
    }
    return true;
  }

  /// Zeros say nothing.
  bool read_biases(const Node& value, Rig& rig) {
    for (const Bias& bias : kBiases) {
      const Node* node = reader_.find(value, bias.key);
      if (node == nullptr) continue;
      const std::optional<std::vector<double>> numbers = reader_.reals(*node, bias.count, bias.key);
      if (!numbers) return false;
      if (std::ranges::any_of(*numbers, [](double number) { return number != 0.0; }))
        rig.extra_fields.push_back({std::string(kImu), std::string(bias.key), fields::value_text(*node)});
    }
    return true;
  }

  bool read_time_offset(const Node& value, Rig& rig) {
    const Node* node = reader_.find(value, "cam_time_offset_ns");
    if (node == nullptr) return true;
    const std::optional<double> offset = reader_.real(*node, "cam_time_offset_ns");
    if (!offset) return false;
    if (*offset != std::floor(*offset)) {
      reader_.say(*node, Code::kBasaltOffsetNotWhole, {"cam_time_offset_ns", node->value});
      return false;
    }
    const double in_seconds = seconds(*offset);
    if (const Message problem = problem_with_time_offset(in_seconds); problem.is_said()) {
      reader_.say(*node, Code::kBasaltOffsetInvalid, {"cam_time_offset_ns", problem});
      return false;
    }
    for (Camera& camera : rig.cameras) camera.time_offset_s = in_seconds;
    return true;
  }

  void keep_unread(const Node& value, Rig& rig) {
    for (const text::Entry& entry : value.entries) {
      const bool read = std::ranges::find(kRequired, entry.key.value) != kRequired.end();
      if (!read && reader_.find(value, entry.key.value) == &entry.value)
        rig.extra_fields.push_back({"", entry.key.value, fields::value_text(entry.value)});
    }
  }

  fields::Reader reader_;
  const ReadOptions& options_;
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() != 1 || !documents.front().root().is_mapping()) {
    diagnostics.add(Code::kBasaltWrongSyntax, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  return CalibrationReader(documents.front(), options, diagnostics).run();
}

}  // namespace fca::basalt
