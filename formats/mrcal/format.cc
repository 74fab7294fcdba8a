// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "mrcal.h"
#include "own_lens.h"

#include "../losses.h"
#include "../name_in_path.h"
#include "../one_camera_files.h"
#include "../schema/keys.h"

#include <fca/code.h>
#include <fca/convert/ray_table.h>
#include <fca/formats/file_name.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace fca::mrcal {

using text::Node;

namespace {

/// "camera-1.cameramodel" is what mrcal-calibrate-cameras writes.
std::string camera_name(std::string_view path) {
  constexpr std::string_view kOfMrcal = "camera-";
  if (const std::string name = indexed_name(path.substr(path.find_last_of('/') + 1), kOfMrcal); !name.empty())
    return "cam" + name.substr(kOfMrcal.size());
  const std::string name = name_by_path(path, "cam");
  return name.empty() ? "cam0" : name;
}

/// A lens of mrcal's own, of which the table has read name, size and the number of its numbers. False with an error.
bool make_table_of_rays(fields::Reader& reader, const Node& root, std::string_view lens, Camera& camera) {
  const std::string name = todays_name(lens);
  const std::optional<std::size_t> count = numbers_of_own_lens(name);
  if (!count) return true;
  const Node& list = *reader.find(root, kIntrinsics);
  const std::optional<std::vector<double>> numbers = reader.reals(list, *count, kIntrinsics);
  if (!numbers) return false;
  std::optional<Camera> table = measured(camera, projection_of_own_lens(name, *numbers), std::numbers::pi);
  if (!table) {
    reader.say(list, Code::kLensWithoutTable, {camera.name, kFewestRays});
    return false;
  }
  camera = *std::move(table);
  return true;
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  const text::Document& document = documents.front();
  const Node& root = document.root();
  if (documents.size() != 1 || !root.is_mapping()) {
    diagnostics.add(Code::kTableWrongSyntax, {}, {document.source().name, 0, 0});
    return std::nullopt;
  }
  Rig rig;
  Camera camera;
  camera.name = camera_name(document.source().name);
  camera.image_size = options.image_size;
  fields::Reader reader(document, kDialect, diagnostics);
  schema::Reading reading{kSchema, reader, options, rig, ""};
  reading.camera = &camera;
  if (!schema::read_mapping(reading, kSchema.root, root)) return std::nullopt;
  if (!make_table_of_rays(reader, root, reading.lens, camera)) return std::nullopt;
  const bool has_pose = !rig.poses.empty() || reader.require(root, kPoseKeys.back(), kSchema.what) != nullptr;
  reader.warn_of_misspelt();
  if (!has_pose) return std::nullopt;
  schema::keep_unread(reading, kSchema.root, root, camera.name);
  rig.cameras.push_back(std::move(camera));
  return rig;
}

bool has_lens_of(const Camera& camera, const Camera& other) {
  return camera.rays == other.rays && camera.image_size == other.image_size;
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const bool is_of_own_lens = there && !there->cameras.front().rays.empty();
  const bool keeps_own_lens =
      is_of_own_lens && !options.rewrite && rig.cameras.size() == 1 && has_lens_of(rig.cameras.front(), there->cameras.front());
  if (!keeps_own_lens && !writable_alone(kFormat, rig, Message{Code::kMrcalDemandsSize}, diagnostics)) return std::nullopt;
  const std::optional<Rig> old = options.rewrite || (is_of_own_lens && !keeps_own_lens) ? std::nullopt : there;
  Written written;
  bool edits = false;
  for (const Camera& camera : rig.cameras) {
    std::optional<text::Document> document;
    if (is_camera_of(old, rig, camera)) {
      document = edited(*base, *old, rig, camera, written);
      edits = true;
    } else {
      document =
          fresh_file(kFormat, camera,
                     {as_file_name(camera.name) + std::string(kFormat.extension), composed(rig, camera, written)}, diagnostics);
    }
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {camera.name}, {"mrcal"}});
  }
  const Message no_place{Code::kFilesHaveNoPlace, {kFormat.program}};
  add_extras_lost(rig, edits ? old->extra_fields : std::vector<ExtraField>(), edits ? std::nullopt : there, no_place,
                  written.losses);
  schema::list_losses(kSchema, rig, no_place, written.losses);
  written.headline = {Code::kTableWrote, {rig.cameras.size() == 1 ? "a camera model" : "camera models", kFormat.program}};
  return written;
}

ProbeResult probe(const text::Document& document) {
  const Node& root = document.root();
  if (!text::is_in_brackets(document.syntax()) || !root.is_mapping()) return {};
  const auto find = [&root](std::string_view key) { return text::find(root, key, kDialect); };
  const auto found = [](std::string_view a, std::string_view b) {
    return Message{Code::kFoundKeys, {std::vector<std::string>{std::string(a), std::string(b)}}};
  };
  for (const std::string_view key : kLensKeys) {
    const Node* lens = find(key);
    const bool is_named = lens != nullptr && (lens->value.starts_with("LENSMODEL_") || lens->value.starts_with("DISTORTION_"));
    if (is_named || (lens != nullptr && find(kImageSize) != nullptr)) return {evidence::kCamera, found(key, lens->value)};
  }
  if (find(kImageSize) == nullptr) return {};
  for (const std::string_view key : {kIntrinsics, kPoseKeys[0], kPoseKeys[1]}) {
    if (find(key) != nullptr) return {evidence::kPart, found(kImageSize, key)};
  }
  return {};
}

constexpr std::string_view kReader = "mrcal";
constexpr std::array kNoTilt = {ParameterRange{"tau_x", 0.0, 0.0}, ParameterRange{"tau_y", 0.0, 0.0}};
constexpr std::array kModels = {
    StoredModel{"radtan", "LENSMODEL_OPENCV5", true, kReader, {}},
    StoredModel{"rational", "LENSMODEL_OPENCV8", true, kReader, {}},
    StoredModel{"opencv14", "LENSMODEL_OPENCV12", true, kReader, kNoTilt, Code::kMrcalNoTilt},
    StoredModel{"pinhole", "LENSMODEL_PINHOLE", true, kReader, {}},
};
constexpr std::array kOwnFacts = {OwnFact{"valid_intrinsics_region, optimization_inputs"}};
/// Of a format that specifies the poses of a pair alone; of others all cameras' or none's are known.
constexpr std::array kDemands = {Demand{"pose in a common frame", "extrinsics", &Format::pair_poses}};
constexpr std::array kOfTheImages = {kRegion};

}  // namespace

const Format kFormat = {
    .id = "mrcal",
    .title = "mrcal camera model",
    .group = FormatGroup::kCalibration,
    .syntaxes = "Python",
    .extension = ".cameramodel",
    .program = "mrcal",
    .main_file = "camera-0.cameramodel",
    .many_cameras = false,
    .extrinsics = true,
    .imu = false,
    .image_size = true,
    .frame = kReference,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .of_the_images = kOfTheImages,
    .models = kModels,
    .table = &kSchema,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::mrcal
