// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "woodscape.h"

#include "../fields.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::woodscape {

using text::Node;

namespace {

constexpr std::string_view kRootKeys[] = {"extrinsic", "intrinsic", "name"};
constexpr std::string_view kIntrinsicKeys[] = {"aspect_ratio", "cx_offset", "cy_offset", "height",     "k1",   "k2",
                                               "k3",           "k4",        "model",     "poly_order", "width"};
constexpr std::string_view kExtrinsicKeys[] = {"quaternion", "translation"};

class CameraReader {
 public:
  CameraReader(const text::Document& document, Diagnostics& diagnostics)
      // Of equal keys Python's json takes the last, as PyYAML does.
      : reader_(document, text::Dialect::kPyYaml, diagnostics) {}

  std::optional<Rig> run() {
    const Node& root = reader_.document().root();
    const Node* intrinsic = mapping(root, "intrinsic", true);
    if (intrinsic == nullptr) return std::nullopt;
    Camera camera;
    camera.name = "cam0";
    if (const Node* name = reader_.find(root, "name"); name != nullptr) {
      if (std::string own = reader_.name(*name, "name"); !own.empty()) camera.name = std::move(own);
    }
    camera.model = *make_model("woodscape");
    if (!read_intrinsic(*intrinsic, camera)) return std::nullopt;
    Rig rig;
    if (!read_extrinsic(root, camera.name, rig)) return std::nullopt;
    keep_unread(root, "", kRootKeys, rig);
    keep_unread(*intrinsic, "intrinsic.", kIntrinsicKeys, rig);
    if (const Node* extrinsic = reader_.find(root, "extrinsic"))
      keep_unread(*extrinsic, "extrinsic.", rig.poses.empty() ? std::span<const std::string_view>() : kExtrinsicKeys, rig);
    reader_.warn_of_misspelt();
    rig.cameras.push_back(std::move(camera));
    return rig;
  }

 private:
  /// A missing part of the pose is a warning.
  static std::vector<Message> pose_not_known() { return {{Code::kWoodscapeJsonPoseNotKnown}}; }

  /// A mapping under a key; an error (or, if it may be missing, a warning) if it is not there.
  const Node* mapping(const Node& owner, std::string_view key, bool required) {
    const Node* node = reader_.find(owner, key);
    if (node != nullptr && node->is_mapping()) return node;
    SourceRange where = reader_.document().range(node == nullptr ? owner : *node);
    where.length = 1;
    reader_.diagnostics().add(required ? Severity::kError : Severity::kWarning,
                              node == nullptr ? Code::kWoodscapeJsonMissing : Code::kWoodscapeJsonNoObject,
                              {key, required ? std::vector<Message>() : pose_not_known()}, where);
    return nullptr;
  }

  const Node* require(const Node& intrinsic, std::string_view key) {
    const Node* node = reader_.find(intrinsic, key);
    if (node == nullptr) {
      SourceRange where = reader_.document().range(intrinsic);
      where.length = 1;
      reader_.diagnostics().add(Code::kWoodscapeJsonMissingKey, {"intrinsic", key, std::vector<Message>()}, where);
    }
    return node;
  }

  /// What the file says of its model. projection.py looks at neither, but forks use the name for other models, and a fifth
  /// coefficient would be left out.
  bool check_model(const Node& intrinsic) {
    bool good = true;
    const Node* model = reader_.find(intrinsic, "model");
    if (model != nullptr && model->value != "radial_poly") {
      reader_.say(*model, Code::kWoodscapeJsonOtherModel, {model->value});
      good = false;
    }
    const Node* order = reader_.find(intrinsic, "poly_order");
    if (order != nullptr && text::parse_real(order->value) != 4.0) {
      reader_.say(*order, Code::kWoodscapeJsonOtherOrder, {order->value});
      good = false;
    }
    return good;
  }

  /// k1 is the radius per radian near the axis, in pixels: 200 to 600 for the dataset's cameras.
  bool check_scale(const Node& k1, const CameraModel& model) {
    constexpr double kFewestPixels = 20.0;  // 10.3 are a dataset camera's pixels per degree
    const double value = parameter(model, "k1").value();
    if (value >= kFewestPixels) return true;
    if (value > 1.0) {
      reader_.say(k1, Code::kWoodscapeJsonPerDegree, {k1.value, value * 180.0 / std::numbers::pi});
    } else {
      reader_.say(k1, Code::kWoodscapeJsonKannalaBrandt, {k1.value});
    }
    return false;
  }

  bool read_intrinsic(const Node& intrinsic, Camera& camera) {
    bool good = check_model(intrinsic);
    for (const ParameterId id : kParameterKeys) {
      const Node* node = require(intrinsic, id.name());
      good = node != nullptr && reader_.parameter(*node, "intrinsic", id, camera.model) && good;
      if (good && id == ParameterId("k1")) good = check_scale(*node, camera.model);
    }
    const Node* width = require(intrinsic, "width");
    const Node* height = require(intrinsic, "height");
    if (width != nullptr && height != nullptr) camera.image_size = reader_.image_size(*width, *height, "intrinsic ");
    good = good && camera.image_size;
    const ImageSize size = camera.image_size.value_or(ImageSize{});
    good = read_centre(intrinsic, "cx_offset", "cx", size.width, camera.model) && good;
    good = read_centre(intrinsic, "cy_offset", "cy", size.height, camera.model) && good;
    for (const std::string_view key : {"k5", "k6"}) {
      const Node* more = reader_.find(intrinsic, key);
      if (more == nullptr || text::parse_real(more->value) == 0.0) continue;
      reader_.say(*more, Code::kWoodscapeJsonReadByNobody, {key});
    }
    return good;
  }

  bool read_centre(const Node& intrinsic, std::string_view key, ParameterId id, int size, CameraModel& model) {
    const Node* node = require(intrinsic, key);
    const std::optional<double> offset = node != nullptr ? reader_.real(*node, key) : std::nullopt;
    return offset && reader_.parameter(*node, key, id, centre_of(*offset, size), model);
  }

  /// False with an error if what stands there is no pose; a missing one is a warning.
  bool read_extrinsic(const Node& root, const std::string& name, Rig& rig) {
    const Node* extrinsic = mapping(root, "extrinsic", false);
    if (extrinsic == nullptr) return true;
    const Node* quaternion = reader_.find(*extrinsic, "quaternion");
    const Node* translation = reader_.find(*extrinsic, "translation");
    if (translation == nullptr && warn_of_carla(*extrinsic)) return true;
    for (const auto& [node, key] : {std::pair{quaternion, "quaternion"}, std::pair{translation, "translation"}}) {
      if (node != nullptr) continue;
      SourceRange where = reader_.document().range(*extrinsic);
      where.length = 1;
      reader_.diagnostics().add(Severity::kWarning, Code::kWoodscapeJsonMissingKey, {"extrinsic", key, pose_not_known()},
                                where);
    }
    if (quaternion == nullptr || translation == nullptr) return true;
    const std::optional<std::vector<double>> q = reader_.reals(*quaternion, 4, "quaternion (x y z w)");
    const std::optional<std::vector<double>> t = reader_.reals(*translation, 3, "translation");
    if (!q || !t) return false;
    const double norm = std::hypot(std::hypot((*q)[0], (*q)[1]), std::hypot((*q)[2], (*q)[3]));
    if (!(norm > 0.0)) {
      reader_.say(*quaternion, Code::kWoodscapeJsonQuaternionZero);
      return false;
    }
    // scipy normalises any length whose square neither over- nor underflows; a far other one is no quaternion of a rotation.
    constexpr double kLongest = 1e3;
    if (norm > kLongest || norm < 1.0 / kLongest) {
      const auto beyond = std::ranges::find_if(*q, [](double value) { return std::abs(value) > kLongest; });
      const Node& place = beyond == q->end() ? *quaternion : quaternion->items[static_cast<std::size_t>(beyond - q->begin())];
      reader_.say(place, Code::kWoodscapeJsonQuaternionLength, {norm});
      return false;
    }
    constexpr double kPrinted = 1e-3;
    if (std::abs(norm - 1.0) > kPrinted) reader_.say(*quaternion, Code::kWoodscapeJsonQuaternionNormalised, {norm});
    const std::optional<Transform> T =
        reader_.checked(pose_of(normalised({(*q)[0], (*q)[1], (*q)[2], (*q)[3]}), {(*t)[0], (*t)[1], (*t)[2]}),
                        {*quaternion, "quaternion"}, {*translation, "translation"});
    if (!T) return false;
    rig.poses.push_back({std::string(kVehicle), name, *T});
    rig.add_frame(kVehicle, FrameKind::kVehicle);
    return true;
  }

  /// The published files cannot all be read by one rule: two have the height behind x and y to the right of it, two before.
  bool warn_of_carla(const Node& extrinsic) {
    const text::Entry* carla = text::find_entry(extrinsic, kCarlaTranslation, reader_.dialect());
    if (carla == nullptr) return false;
    reader_.say(carla->key, Code::kWoodscapeJsonCarla, {"translation"});
    return true;
  }

  void keep_unread(const Node& node, const std::string& parent, std::span<const std::string_view> known, Rig& rig) {
    for (const text::Entry& entry : node.entries) {
      if (std::ranges::find(known, entry.key.value) != known.end()) continue;
      rig.extra_fields.push_back({"", parent + entry.key.value, fields::value_text(entry.value)});
    }
  }

  fields::Reader reader_;
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& /*options*/, Diagnostics& diagnostics) {
  if (documents.size() != 1 || !documents.front().root().is_mapping()) {
    diagnostics.add(Code::kWoodscapeJsonOneObject, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  return CameraReader(documents.front(), diagnostics).run();
}

}  // namespace fca::woodscape
