// SPDX-License-Identifier: BSD-3-Clause
#include "woodscape.h"

#include "../losses.h"
#include "../one_camera_files.h"
#include "../schema/keys.h"

#include <fca/code.h>
#include <fca/formats/file_name.h>

#include <algorithm>
#include <array>

namespace fca::woodscape {

using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  std::optional<Rig> rig = schema::read(kSchema, documents, options, diagnostics);
  if (!rig) return rig;
  // Half a pose is kept.
  const Node* extrinsic = text::find(documents.front().root(), "extrinsic", kDialect);
  for (const text::Entry& entry : extrinsic != nullptr ? extrinsic->entries : std::vector<text::Entry>()) {
    const bool of_pose = entry.key.value == "quaternion" || entry.key.value == "translation";
    if (rig->poses.empty() || !of_pose)
      rig->extra_fields.push_back({"", "extrinsic." + entry.key.value, fields::value_text(entry.value)});
  }
  return rig;
}

/// The base with the camera and its pose. Its own name and, where the rotation is the same, its own quaternion stay.
text::Document edited(const text::Document& base, const Subject& before, const Subject& after, Written& written) {
  text::Document document = schema::edited(base, before, after, written);
  const Node& root = document.root();
  if (text::find(root, "extrinsic", kDialect) != nullptr) return document;
  if (!schema::PoseFrame(after.rig, kPoseInVehicle).own_pose(after.the_camera())) return document;
  std::string keys;
  for (const Statement& statement : schema::write_pose(after, pose_key()))
    keys += (keys.empty() ? "" : ", ") + fields::spell(statement.field, 0, text::Syntax::kJson);
  document.insert_after(root, root.entries.front(), "\"extrinsic\": {" + keys + "}");
  return document;
}

/// CARLA's translation is the same pose in another frame: next to a new one it no longer holds.
void list_stale_translation(const text::Document& base, const Rig& old, const std::string& camera, const Transform& pose,
                            std::vector<Loss>& losses) {
  const Transform* stated = old.stated(kPoseInVehicle.frame, camera);
  if (stated != nullptr && *stated == pose) return;
  const Node* extrinsic = text::find(base.root(), "extrinsic", kDialect);
  if (extrinsic == nullptr || text::find(*extrinsic, kCarlaTranslation, kDialect) == nullptr) return;
  losses.push_back(lost(Code::kWoodscapeStaleTranslation, camera, std::string(kCarlaTranslation)));
}

/// What the input says besides its rig and the file, which says `there`, does not.
void list_extras(std::span<const ExtraField> extras, std::span<const ExtraField> there, std::vector<Loss>& losses) {
  std::vector<ExtraField> others(extras.begin(), extras.end());
  const auto halves = std::stable_partition(others.begin(), others.end(), [](const ExtraField& extra) {
    return !extra.key.ends_with("extrinsic.quaternion") && !extra.key.ends_with("extrinsic.translation");
  });
  const auto count = static_cast<std::size_t>(halves - others.begin());
  add_beyond_base(std::span(others).first(count), there, Message{Code::kWoodscapeJsonNoPlace}, losses);
  add_beyond_base(std::span(others).subspan(count), there, Message{Code::kWoodscapeJsonHalfAPose}, losses);
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  if (!writable_alone(kFormat, rig, Message{Code::kWoodscapeJsonCentreFromMiddle}, diagnostics)) return std::nullopt;
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const std::optional<Rig> old = options.rewrite ? std::nullopt : there;
  Written written;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    std::optional<text::Document> document;
    std::vector<std::string> programs = {"woodscape"};
    if (is_camera_of(old, rig, camera)) {
      document = edited(*base, {kSchema, *old}, {kSchema, rig, i}, written);
      const std::optional<Transform> pose = schema::PoseFrame(rig, kPoseInVehicle).own_pose(camera);
      // SynWoodScape's JSONs, for one, belong to other programs: no pose is made up to please this one.
      if (document->edited() && !pose) programs.clear();
      if (pose && document->edited()) list_stale_translation(*base, *old, camera.name, *pose, written.losses);
    } else {
      document = fresh_file(
          kFormat, camera, {as_file_name(camera.name) + ".json", schema::composed_json(kSchema, rig, i, written)}, diagnostics);
    }
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {camera.name}, std::move(programs)});
  }
  schema::list_losses(kSchema, rig, Message{Code::kFilesHaveNoPlace, {"WoodScape"}}, written.losses);
  list_extras(rig.extra_fields, old ? old->extra_fields : std::vector<ExtraField>(), written.losses);
  if (there && !old)
    add_not_carried(extras_beyond(there->extra_fields, rig.extra_fields), Message{Code::kFileRewritten}, written.losses);
  const bool for_projection_py =
      std::ranges::none_of(written.files, [](const Written::File& file) { return file.programs.empty(); });
  written.headline = {!for_projection_py        ? Code::kWoodscapeJsonHeadlineNoPose
                      : rig.cameras.size() == 1 ? Code::kWoodscapeJsonHeadline
                                                : Code::kWoodscapeJsonHeadlineEach};
  return written;
}

ProbeResult probe(const text::Document& document) {
  const Node& root = document.root();
  const Node* intrinsic = text::find(root, "intrinsic", kDialect);
  if (intrinsic == nullptr || !intrinsic->is_mapping()) return {};
  const Node* model = text::find(*intrinsic, "model", kDialect);
  if (model != nullptr && model->value == kModel)
    return {evidence::kCamera, Message{Code::kWoodscapeJsonWithKey, {"model \"radial_poly\""}}};
  for (const std::string_view key : {"cx_offset", "cy_offset", "poly_order"}) {
    if (text::find(*intrinsic, key, kDialect) != nullptr) return {evidence::kPart, Message{Code::kWoodscapeJsonWithKey, {key}}};
  }
  const Node* extrinsic = text::find(root, "extrinsic", kDialect);
  if (extrinsic != nullptr && text::find(*extrinsic, "quaternion", kDialect) != nullptr &&
      text::find(*intrinsic, "k1", kDialect) != nullptr)
    return {evidence::kHint, Message{Code::kWoodscapeJsonWithQuaternion}};
  return {};
}

/// Below, k1 cannot be pixels per radian: the reader refuses it, and so no camera may be written with one.
constexpr std::array kInPixels = {ParameterRange{"k1", 10.0, 1e9}};
constexpr std::array kModels = {
    StoredModel{"woodscape", kModel, true, "WoodScape's projection.py", kInPixels, Code::kWoodscapeJsonInPixels}};
constexpr std::array kOwnFacts = {OwnFact{"keys of its own"}};
constexpr std::array kDemands = {Demand{.name = "pose in the vehicle", .key = "extrinsic", .of_frame = true}};

}  // namespace

const Format kFormat = {
    .id = "woodscape",
    .title = "WoodScape JSON",
    .group = FormatGroup::kDatasets,
    .syntaxes = "JSON",
    .extension = ".json",
    .program = "WoodScape",
    .many_cameras = false,
    .extrinsics = true,
    .imu = false,
    .image_size = true,
    .frame = "vehicle",
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .models = kModels,
    .table = &kSchema,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::woodscape
