// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "kalibr.h"
#include "layout.h"
#include "poses.h"
#include "report.h"

#include "../schema/schema.h"

#include <fca/code.h>
#include <fca/formats/text/prose.h>

#include <algorithm>

namespace fca::kalibr {

using text::Node;

namespace {

class ChainReader {
 public:
  ChainReader(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics)
      : reader_(document, dialect_of(document), diagnostics), options_(options) {}

  void read_into(Rig& rig) {
    const Node& root = reader_.document().root();
    const bool bare_imu = holds_noise(root);  // imu.yaml: its keys stand at the top
    if (bare_imu) read_imu(root, "imu0", rig);
    reader_.warn_of_duplicates(root);
    const std::vector<const text::Entry*> shadowed = text::shadowed_entries(root, reader_.dialect());
    for (const text::Entry& entry : root.entries) {
      if (std::ranges::binary_search(shadowed, &entry)) continue;
      if (index_in(entry.key.value, "cam")) {
        read_camera(entry.value, entry.key, rig);
      } else if (index_in(entry.key.value, "imu") && entry.value.is_mapping()) {
        read_imu(entry.value, entry.key.value, rig);
      } else if (!read_named_pose(entry, rig) && !bare_imu) {
        warn_of_misnamed_camera(entry);
        rig.extra_fields.push_back({"", entry.key.value, fields::value_text(entry.value)});
      }
    }
    reader_.warn_of_misspelt();
    // Kalibr counts cam0, cam1, ... wherever they stand.
    std::ranges::stable_sort(rig.cameras, {}, [](const Camera& camera) { return *index_in(camera.name, "cam"); });
  }

 private:
  /// What it holds would be lost without a word.
  void warn_of_misnamed_camera(const text::Entry& entry) {
    if (!entry.value.is_mapping() || text::find(entry.value, "camera_model", reader_.dialect()) == nullptr) return;
    reader_.say(entry.key, Code::kCamchainMisnamedCamera, {entry.key.value});
  }

  void read_camera(const Node& node, const Node& key, Rig& rig) {
    const std::string& name = key.value;
    if (!node.is_mapping()) {
      reader_.say(key, Code::kCamchainNoMapping, {name});
      return;
    }
    reader_.warn_of_duplicates(node);
    Camera camera;
    camera.name = name;
    camera.image_size = options_.image_size;
    if (!read_model(node, key, camera)) return;
    schema::Reading block = reading(name, rig);
    block.camera = &camera;
    if (!schema::read_mapping(block, kCameraBlock, node)) return;
    schema::keep_unread(block, kCameraBlock, node, name);
    rig.cameras.push_back(std::move(camera));
  }

  schema::Reading reading(const std::string& owner, Rig& rig) { return {kChain, reader_, options_, rig, owner}; }

  bool read_model(const Node& node, const Node& key, Camera& camera) {
    const std::string& name = key.value;
    const auto string_at = [&](std::string_view k) -> std::optional<std::string> {
      const Node* value = reader_.find(node, k);
      if (value == nullptr) {
        reader_.say(key, Code::kKeyMissing, {name, k});
        return std::nullopt;
      }
      return reader_.string(*value, name + " " + std::string(k));
    };
    const std::optional<std::string> camera_model = string_at("camera_model");
    const std::optional<std::string> distortion_model = string_at("distortion_model");
    if (!camera_model || !distortion_model) return false;

    const auto& rows = layouts();
    const bool known_camera = std::ranges::any_of(rows, [&](const Layout& l) { return l.camera_model == *camera_model; });
    const auto layout = std::ranges::find_if(
        rows, [&](const Layout& l) { return l.camera_model == *camera_model && l.distortion_model == *distortion_model; });
    std::vector<Message> meant;
    if (Message nearest = nearest_layout(*camera_model, *distortion_model); nearest.is_said()) meant = {std::move(nearest)};
    if (!known_camera) {
      const std::vector<std::string> names = {"pinhole", "omni", "eucm", "ds"};
      reader_.say(*reader_.find(node, "camera_model"), Code::kCamchainUnknownCamera, {name, *camera_model, names, meant});
      return false;
    }
    if (layout == rows.end()) {
      reader_.say(*reader_.find(node, "distortion_model"), Code::kCamchainUnknownDistortion,
                  {name, *camera_model, *distortion_model, meant});
      return false;
    }
    camera.model = *make_model(layout->model);
    if (!read_slots(node, key, "intrinsics", layout->intrinsics, camera) ||
        !read_slots(node, key, "distortion_coeffs", layout->coefficients, camera)) {
      return false;
    }
    const StoredModel* stored = find_stored_model(kFormat, layout->model, true);
    for (const ParameterRange& range : stored->ranges) {
      if (within(camera.model, std::span(&range, 1))) continue;
      const Code why = range.parameter == ParameterId("alpha") ? Code::kCamchainAlphaBelowOne : Code::kCamchainRadtanNoK3;
      reader_.say(*reader_.find(node, "intrinsics"), Code::kCamchainOutsideRange,
                  {name, range.parameter.name(), parameter(camera.model, range.parameter).value(), Message{why}});
    }
    return true;
  }

  bool read_slots(const Node& node, const Node& key, std::string_view list_key, std::span<const Slot> slots, Camera& camera) {
    const Node* list = reader_.find(node, list_key);
    if (list == nullptr) {
      if (slots.empty()) return true;
      reader_.say(key, Code::kKeyMissing, {key.value, list_key});
      return false;
    }
    const std::string what = key.value + " " + std::string(list_key);
    if (!list->is_sequence()) {
      reader_.say(*list, Code::kCamchainNoList, {what, slots.size()});
      return false;
    }
    if (list->items.size() != slots.size()) {
      reader_.say(*list, Code::kCamchainWrongLength, {what, list->items.size(), slots.size()});
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (slots[i].parameter) good = reader_.parameter(list->items[i], what, *slots[i].parameter, camera.model) && good;
    }
    return good;
  }

  /// A top-level T_cam1_cam0, as some forks and converters write it.
  bool read_named_pose(const text::Entry& entry, Rig& rig) {
    const std::optional<PoseKey> pose = named_pose_key(entry.key.value);
    if (!pose) return false;
    if (const std::optional<Transform> T = reader_.transform(entry.value, pose->key)) add_pose(*pose, *T, rig);
    return true;
  }

  void read_imu(const Node& node, const std::string& name, Rig& rig) {
    Imu imu;
    imu.name = name;
    schema::Reading block = reading(name, rig);
    block.imu = &imu;
    if (!schema::read_mapping(block, kImuBlock, node)) return;
    schema::keep_unread(block, kImuBlock, node, name);
    rig.imus.push_back(std::move(imu));
  }

  fields::Reader reader_;
  const ReadOptions& options_;
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    Diagnostics found;
    if (is_report(document)) {
      read_report(document, rig, found);
    } else {
      ChainReader(document, options, found).read_into(rig);
    }
    for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
    if (found.has_errors()) return std::nullopt;
  }
  if (rig.cameras.empty() && rig.imus.empty() && rig.uncertainties.empty()) {
    diagnostics.add(Code::kCamchainNothing, {}, {documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  return rig;
}

}  // namespace fca::kalibr
