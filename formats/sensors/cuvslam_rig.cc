// SPDX-License-Identifier: BSD-3-Clause
#include "cuvslam_rig.h"

#include "../fields.h"
#include "../losses.h"
#include "../one_camera_files.h"
#include "../schema/schema.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace fca::cuvslam_rig {

using fields::Field;
using text::Node;

namespace {

constexpr text::Dialect kDialect = text::Dialect::kPyYaml;
constexpr std::string_view kRig = "rig";
constexpr std::string_view kStereoCameras = "stereo_cameras";
constexpr std::array<std::string_view, 2> kSides = {"left_camera", "right_camera"};
constexpr std::string_view kTransform = "transform";
constexpr std::string_view kColourCamera = "rgb_camera";
constexpr std::string_view kFocalLength = "focal_length";
constexpr std::string_view kPrincipalPoint = "principal_point";
constexpr std::string_view kWidth = "image_width";
constexpr std::string_view kHeight = "image_height";
constexpr std::array kOfColourCamera = {kFocalLength, kPrincipalPoint, kWidth, kHeight};
constexpr std::size_t kRows = 3;
constexpr std::size_t kColumns = 4;

const Node* find(const Node& mapping, std::string_view key) { return text::find(mapping, key, kDialect); }

std::string camera_name(std::size_t index) { return "cam" + std::to_string(index); }

/// Is there a number other than 0 in the value?
bool has_number(const Node& node) {
  if (node.is_scalar()) return text::parse_real(node.value).value_or(0.0) != 0.0;
  return std::ranges::any_of(node.items, has_number) ||
         std::ranges::any_of(node.entries, [](const text::Entry& entry) { return has_number(entry.value); });
}

/// The key of a lens' coefficients, by the names that other programs have for it (distortion, dist_coeffs, k1)?
bool is_distortion(std::string_view key) {
  const bool is_one = key.size() == 2 && (key[0] == 'k' || key[0] == 'p') && key[1] >= '1' && key[1] <= '9';
  return is_one || key.starts_with("dist");
}

/// The rows of all transforms, in the order of the cameras. Of a file that can be read.
std::vector<const Node*> transforms_in(const Node& root) {
  std::vector<const Node*> transforms;
  const Node* pairs = find(root, kStereoCameras);
  for (const Node& pair : pairs != nullptr ? std::span<const Node>(pairs->items) : std::span<const Node>()) {
    for (const std::string_view side : kSides) transforms.push_back(find(*find(pair, side), kTransform));
  }
  return transforms;
}

class RigReader {
 public:
  RigReader(const text::Document& document, Diagnostics& diagnostics) : reader_(document, kDialect, diagnostics) {}

  std::optional<Rig> run() {
    const Node& root = reader_.document().root();
    reader_.warn_of_duplicates(root);
    const bool is_colour = find(root, kColourCamera) != nullptr;
    const bool good = is_colour ? read_colour_camera(root) : read_pairs(*reader_.find(root, kStereoCameras));
    if (!good) return std::nullopt;
    keep_others(root, is_colour ? std::array{kColourCamera} : std::array{kStereoCameras}, "");
    reader_.warn_of_misspelt();
    return std::move(rig_);
  }

 private:
  bool read_pairs(const Node& pairs) {
    rig_.add_frame(std::string(kRig), FrameKind::kOther);
    for (const Node& pair : pairs.items) {
      const std::string first = camera_name(rig_.poses.size());
      if (!is_object(pair, kStereoCameras)) return false;
      for (const std::string_view side : kSides) {
        const std::string name = camera_name(rig_.poses.size());
        const Node* camera = reader_.require(pair, side, "a pair of cameras");
        if (camera == nullptr || !is_object(*camera, side) || !read_pose(*camera, name)) return false;
        keep_others(*camera, std::array{kTransform}, name);
      }
      keep_others(pair, kSides, first);
    }
    return true;
  }

  /// What stands next to the keys that are read. Of equal keys the one that counts.
  void keep_others(const Node& mapping, std::span<const std::string_view> read, const std::string& owner) {
    for (const text::Entry& entry : mapping.entries) {
      const std::string& key = entry.key.value;
      if (std::ranges::find(read, key) != read.end() || find(mapping, key) != &entry.value) continue;
      rig_.extra_fields.push_back({owner, key, fields::value_text(entry.value)});
    }
  }

  bool is_object(const Node& node, std::string_view what) {
    if (node.is_mapping()) return true;
    reader_.say(node, Code::kTableNoObject, {what});
    return false;
  }

  bool read_pose(const Node& camera, const std::string& name) {
    const Node* rows = reader_.require(camera, kTransform, name);
    if (rows == nullptr) return false;
    const std::string what = name + " " + std::string(kTransform);
    if (!rows->is_sequence() || rows->items.size() != kRows) {
      reader_.say(*rows, Code::kRowsWanted, {what, rows->items.size(), kRows});
      return false;
    }
    Transform T;
    for (std::size_t row = 0; row < kRows; ++row) {
      const std::optional<std::vector<double>> numbers = reader_.reals(rows->items[row], kColumns, what);
      if (!numbers) return false;
      for (std::size_t column = 0; column < kColumns; ++column) T.values.at(kColumns * row + column) = (*numbers)[column];
    }
    const std::optional<Transform> checked = reader_.checked(T, *rows, what);
    if (checked) rig_.poses.push_back({std::string(kRig), name, *checked});
    return checked.has_value();
  }

  bool read_colour_camera(const Node& root) {
    const Node& node = *find(root, kColourCamera);
    Camera camera;
    camera.name = camera_name(0);
    camera.model = make_model("pinhole").value();
    const Node* width = reader_.require(node, kWidth, kColourCamera);
    const Node* height = reader_.require(node, kHeight, kColourCamera);
    if (width == nullptr || height == nullptr) return false;
    camera.image_size = reader_.image_size(*width, *height, camera.name + " ");
    const bool good = camera.image_size && read_pair(node, kFocalLength, {"fx", "fy"}, camera) &&
                      read_pair(node, kPrincipalPoint, {"cx", "cy"}, camera);
    if (!good) return false;
    for (const text::Entry& entry : node.entries) {
      if (is_distortion(entry.key.value) && has_number(entry.value))
        reader_.say(entry.key, Code::kCuvslamNoDistortion, {kColourCamera, entry.key.value});
    }
    keep_others(node, kOfColourCamera, camera.name);
    rig_.cameras.push_back(std::move(camera));
    return true;
  }

  bool read_pair(const Node& node, std::string_view key, const std::array<ParameterId, 2>& ids, Camera& camera) {
    const Node* list = reader_.require(node, key, kColourCamera);
    const std::optional<std::vector<double>> numbers =
        list != nullptr ? reader_.reals(*list, ids.size(), camera.name + " " + std::string(key)) : std::nullopt;
    if (!numbers) return false;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!reader_.parameter(list->items[i], camera.name, ids.at(i), (*numbers)[i], camera.model)) return false;
    }
    return true;
  }

  fields::Reader reader_;
  Rig rig_;
};

std::vector<Field> colour_fields(const Camera& camera) {
  const auto value = [&camera](ParameterId id) { return parameter(camera.model, id).value(); };
  return {fields::list(std::string(kFocalLength), std::array{value("fx"), value("fy")}),
          fields::list(std::string(kPrincipalPoint), std::array{value("cx"), value("cy")}),
          fields::integer(std::string(kWidth), camera.image_size->width),
          fields::integer(std::string(kHeight), camera.image_size->height)};
}

void edit_poses(const Rig& old, const Rig& rig, text::Document& document) {
  const std::vector<const Node*> transforms = transforms_in(document.root());
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const Transform& before = old.poses[i].T_a_b;
    const std::optional<Transform> now = rig.resolve(old.poses[i].a, old.poses[i].b);
    for (std::size_t k = 0; now && k < kRows * kColumns; ++k) {
      const Node& number = transforms[i]->items[k / kColumns].items[k % kColumns];
      if (before.values.at(k) != now->values.at(k)) fields::set_scalar(document, number, text::format_real(now->values.at(k)));
    }
  }
}

}  // namespace

bool is_rig(const text::Document& document) {
  const Node& root = document.root();
  if (!root.is_mapping()) return false;
  const Node* camera = find(root, kColourCamera);
  if (camera != nullptr && camera->is_mapping() && find(*camera, kFocalLength) != nullptr) return true;
  const Node* pairs = find(root, kStereoCameras);
  if (pairs == nullptr || !pairs->is_sequence() || pairs->items.empty() || !pairs->items.front().is_mapping()) return false;
  return std::ranges::any_of(kSides, [pairs](std::string_view side) {
    const Node* of_pair = find(pairs->items.front(), side);
    return of_pair != nullptr && of_pair->is_mapping() && find(*of_pair, kTransform) != nullptr;
  });
}

ProbeResult probe(const text::Document& document) {
  if (!is_rig(document)) return {};
  const bool is_colour = find(document.root(), kColourCamera) != nullptr;
  return {evidence::kCamera, Message{Code::kCuvslamRigFound, {is_colour ? kColourCamera : kStereoCameras}}};
}

std::optional<Rig> read(const text::Document& document, Diagnostics& diagnostics) {
  return RigReader(document, diagnostics).run();
}

std::optional<Written> edited(const text::Document& base, const Rig& rig) {
  Diagnostics ignored;
  const std::optional<Rig> old = read(base, ignored);
  if (!old) return std::nullopt;
  text::Document document = base;
  Written written;
  if (old->cameras.empty()) {
    edit_poses(*old, rig, document);
    written.files.push_back({std::move(document), {}, {"cuvslam-imu"}});
  } else {
    const bool holds = schema::same_cameras(*old, rig) && rig.cameras.size() == 1 && rig.cameras.front().image_size &&
                       model_info(rig.cameras.front().model).id == "pinhole";
    if (!holds) return std::nullopt;
    fields::apply(document, *find(base.root(), kColourCamera), kDialect, colour_fields(old->cameras.front()),
                  colour_fields(rig.cameras.front()));
    written.files.push_back({std::move(document), {rig.cameras.front().name}, {"cuvslam"}});
  }
  add_extras_lost(rig, old->extra_fields, std::nullopt, Message{Code::kFilesHaveNoPlace, {"cuVSLAM's examples"}},
                  written.losses);
  list_camera_losses(rig, "cuVSLAM", written.losses);
  written.headline = {Code::kCuvslamRigHeadline};
  return written;
}

}  // namespace fca::cuvslam_rig
