// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "woodscape.h"

#include "../fields.h"

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
  static std::string key_error(std::string_view key) { return "projection.py stops with KeyError: '" + std::string(key) + "'"; }

  /// A mapping under a key; an error (or, if it may be missing, a warning) if it is not there.
  const Node* mapping(const Node& owner, std::string_view key, bool required) {
    const Node* node = reader_.find(owner, key);
    if (node != nullptr && node->is_mapping()) return node;
    const std::string problem =
        node == nullptr ? "there is no " + std::string(key) : std::string(key) + " is no object of keys and values";
    SourceRange where = reader_.document().range(node == nullptr ? owner : *node);
    where.length = 1;
    if (required) {
      reader_.diagnostics().error("missing-key", problem + ": " + key_error(key), where);
    } else {
      reader_.diagnostics().warning("missing-key", problem + ": " + key_error(key) + "; the pose is not known", where);
    }
    return nullptr;
  }

  const Node* require(const Node& intrinsic, std::string_view key) {
    const Node* node = reader_.find(intrinsic, key);
    if (node == nullptr) {
      SourceRange where = reader_.document().range(intrinsic);
      where.length = 1;
      reader_.diagnostics().error("missing-key", "intrinsic has no " + std::string(key) + ": " + key_error(key), where);
    }
    return node;
  }

  /// What the file says of its model. projection.py looks at neither, but forks use the name for other models, and a fifth
  /// coefficient would be left out.
  bool check_model(const Node& intrinsic) {
    bool good = true;
    const Node* model = reader_.find(intrinsic, "model");
    if (model != nullptr && model->value != "radial_poly") {
      reader_.error(
          *model, "unknown-model",
          "model is '" + model->value + "'; fca-io reads WoodScape's \"radial_poly\" (rho = k1 theta + ... + k4 theta^4)");
      good = false;
    }
    const Node* order = reader_.find(intrinsic, "poly_order");
    if (order != nullptr && text::parse_real(order->value) != 4.0) {
      reader_.error(*order, "unknown-model",
                    "poly_order is " + order->value + "; projection.py reads k1 to k4, whatever stands here",
                    "write the coefficients as k1 to k4 and poly_order as 4");
      good = false;
    }
    return good;
  }

  /// k1 is the radius per radian near the axis, in pixels: 200 to 600 for the dataset's cameras.
  bool check_scale(const Node& k1, const CameraModel& model) {
    constexpr double kFewestPixels = 20.0;  // 10.3 are a dataset camera's pixels per degree
    const double value = parameter(model, "k1").value();
    if (value >= kFewestPixels) return true;
    const double per_radian = value * 180.0 / std::numbers::pi;
    std::string guess = "normalised Kannala-Brandt coefficients (theta + k1 theta^3 + ...) under WoodScape's names";
    if (value > 1.0) {
      guess = "pixels per degree (" + k1.value + " per degree are " + text::format_short(per_radian, 4) + " per radian)";
    }
    reader_.error(k1, "not-in-pixels",
                  "k1 = " + k1.value +
                      " is no number of pixels per radian (the dataset's are 200 to 600): the file probably holds " + guess,
                  value > 1.0 ? "multiply k1 .. k4 by 57.29578 to the power of 1 .. 4"
                              : "if so, the focal length is missing here; write the camera as Kalibr's pinhole-equidistant");
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
      reader_.warning(*more, "program-ignores", std::string(key) + " is read by nobody: projection.py takes k1 to k4");
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
      reader_.diagnostics().warning(
          "missing-key", "extrinsic has no " + std::string(key) + ": " + key_error(key) + "; the pose is not known", where);
    }
    if (quaternion == nullptr || translation == nullptr) return true;
    const std::optional<std::vector<double>> q = reader_.reals(*quaternion, 4, "quaternion (x y z w)");
    const std::optional<std::vector<double>> t = reader_.reals(*translation, 3, "translation");
    if (!q || !t) return false;
    const double norm = std::hypot(std::hypot((*q)[0], (*q)[1]), std::hypot((*q)[2], (*q)[3]));
    if (!(norm > 0.0)) {
      reader_.error(*quaternion, "not-a-rotation", "the quaternion is 0: scipy stops with ValueError");
      return false;
    }
    // scipy normalises any length whose square neither over- nor underflows; a far other one is no quaternion of a rotation.
    constexpr double kLongest = 1e3;
    if (norm > kLongest || norm < 1.0 / kLongest) {
      const auto beyond = std::ranges::find_if(*q, [](double value) { return std::abs(value) > kLongest; });
      const Node& place = beyond == q->end() ? *quaternion : quaternion->items[static_cast<std::size_t>(beyond - q->begin())];
      reader_.error(place, "not-a-rotation", "the quaternion has length " + text::format_short(norm, 4) + ", not 1",
                    "a rotation by an angle a about the axis n is [n sin(a/2), cos(a/2)]");
      return false;
    }
    constexpr double kPrinted = 1e-3;
    if (std::abs(norm - 1.0) > kPrinted) {
      reader_.warning(*quaternion, "not-a-rotation",
                      "the quaternion has length " + text::format_short(norm, 4) + ", not 1; projection.py normalises it",
                      "divide its four numbers by that length");
    }
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
    reader_.warning(
        carla->key, "carla-translation",
        "SynWoodScape's translation in CARLA's frame stands where \"translation\" should: " + key_error("translation") +
            ". CARLA is left-handed, its origin is another, and the published files differ in the order of y and z, so "
            "that the pose is left out",
        "add \"translation\": [x, y, z] of the camera in the vehicle (metres; x forward, y left, z up)");
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
    diagnostics.error("wrong-syntax", "a WoodScape calibration is one JSON object",
                      {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  return CameraReader(documents.front(), diagnostics).run();
}

}  // namespace fca::woodscape
