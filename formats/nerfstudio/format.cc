// SPDX-License-Identifier: BSD-3-Clause
#include "nerfstudio.h"

#include "../losses.h"
#include "../one_camera_files.h"
#include "../schema/schema.h"
#include "edit.h"
#include "layout.h"
#include "read.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>

namespace fca::nerfstudio {

using text::Node;

namespace {

ProbeResult probe(const text::Document& document) {
  const Node& root = document.root();
  if (document.syntax() != text::Syntax::kJson || !root.is_mapping()) return {};
  const Node* frames = value_in(root, kFrames);
  const bool has_frames = frames != nullptr && frames->is_sequence();
  const Node& frame = has_frames && !frames->items.empty() ? frames->items.front() : root;
  constexpr std::array<std::string_view, 3> kOfCamera = {"fl_x", "camera_angle_x", "x_fov"};
  for (const std::string_view key : kOfCamera) {
    if (value_in(root, key) != nullptr || value_in(frame, key) != nullptr)
      return {has_frames ? evidence::kCamera : evidence::kPart, Message{Code::kNerfFound, {key}}};
  }
  if (has_frames && value_in(frame, kPose) != nullptr) return {evidence::kPart, Message{Code::kNerfFound, {kPose}}};
  return {};
}

/// False with an error if one is a fisheye and another is none.
bool are_of_one_kind(const Rig& rig, Diagnostics& diagnostics) {
  const auto fisheye = std::ranges::find_if(rig.cameras, is_fisheye);
  const auto straight = std::ranges::find_if(rig.cameras, [](const Camera& camera) { return !is_fisheye(camera); });
  if (fisheye == rig.cameras.end() || straight == rig.cameras.end()) return true;
  diagnostics.add(Code::kNerfKindsDiffer, {fisheye->name, straight->name});
  return false;
}

/// Lines of the camera's numbers. Where they are those of the model without coefficients, these are left out: instant-ngp takes
/// k3 and k4 for p1 and p2, and p1 and p2 for k3 and k4.
std::string lines_of(const Camera& camera, std::size_t depth) {
  std::string text;
  for (const fields::Field& field : numbers_of(camera)) {
    if (field.key == "k3" && !is_fisheye(camera) && field.tokens.front() == "0.0") continue;
    text += fields::spell(field, depth, text::Syntax::kJson) + ",\n";
  }
  return text;
}

/// One camera at the top, several (or one with a name) in a frame each. These have no image yet.
std::string composed(const Rig& rig) {
  const bool one = rig.cameras.size() == 1 && rig.cameras.front().name == "cam0";
  const auto straight =
      std::ranges::find_if(rig.cameras, [](const Camera& camera) { return model_info(camera.model).id != "pinhole"; });
  const Camera& named = straight != rig.cameras.end() ? *straight : rig.cameras.front();
  std::string text = "{\n  \"camera_model\": " + fields::quote(camera_model_for("", named.model)) + ",\n";
  if (is_fisheye(named)) text += "  \"is_fisheye\": true,\n";
  if (one) text += lines_of(rig.cameras.front(), 2);
  text += "  \"frames\": [";
  std::string separator = "\n";
  for (const Camera& camera : rig.cameras) {
    text += separator + "    {\n";
    text += fields::spell(fields::quoted(std::string(kImageFile), "images/" + camera.name + ".png"), 6, text::Syntax::kJson) +
            ",\n";
    if (!one) {
      text += fields::spell(fields::quoted(std::string(kLabel), camera.name), 6, text::Syntax::kJson) + ",\n";
      if (is_fisheye(camera)) text += "      \"is_fisheye\": true,\n";
      text += lines_of(camera, 6);
    }
    text +=
        "      \"transform_matrix\": [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], "
        "[0.0, 0.0, 0.0, 1.0]]\n    }";
    separator = ",\n";
  }
  return text + "\n  ]\n}\n";
}

/// Of fisheyes without coefficients that the base does not specify so already the first gets one that changes no pixel:
/// instant-ngp takes them for pinholes. It is listed among the defaults.
Rig with_coefficients(Rig rig, const std::optional<Rig>& old, Written& written) {
  constexpr double kTiny = 1e-12;
  constexpr std::array<ParameterId, 4> kOfFisheye = {"k1", "k2", "k3", "k4"};
  for (Camera& camera : rig.cameras) {
    const Camera* before = old ? old->find_camera(camera.name) : nullptr;
    const auto is_ideal = [&kOfFisheye](const Camera& each) {
      const auto is_zero = [&each](ParameterId id) { return parameter(each.model, id) == 0.0; };
      return is_fisheye(each) && std::ranges::all_of(kOfFisheye, is_zero);
    };
    if (!is_ideal(camera) || (before != nullptr && is_ideal(*before))) continue;
    set_parameter(camera.model, "k1", kTiny);
    written.defaults.push_back({camera.name + " k1", Message{Code::kNerfTinyCoefficient, {text::format_real(kTiny)}}});
  }
  return rig;
}

/// Whose file is it? nerfstudio stops where a number is not stated, and knows no is_fisheye.
std::string program_of(const text::Document& document) {
  const std::optional<text::Document> after = document.edited() ? text::as_edited(document) : std::nullopt;
  const Node& root = after ? after->root() : document.root();
  const auto states_all = [&root](const Group& group) {
    const auto states = [&](std::string_view key) { return value_in(owner_of(root, group, key), key) != nullptr; };
    return std::ranges::all_of(kFocalAndCentre, states) && std::ranges::all_of(kSize, states);
  };
  const std::vector<Group> groups = groups_of(root);
  const Node& frame = groups.front().frames.empty() ? root : *groups.front().frames.front();
  const Node* flag = value_in(frame, kIsFisheye) != nullptr ? value_in(frame, kIsFisheye) : value_in(root, kIsFisheye);
  const bool other_word = value_in(root, kCameraModel) == nullptr && flag != nullptr && flag->value == "true";
  return other_word || !std::ranges::all_of(groups, states_all) ? "instant-ngp" : "nerfstudio";
}

/// The base as it was read, with the image size that the user had to say where the file leaves it out.
std::optional<Rig> read_base(const text::Document& base, const Rig& rig) {
  Diagnostics ignored;
  std::optional<Rig> old = read(std::span(&base, 1), {}, ignored);
  if (old || rig.cameras.empty()) return old;
  ReadOptions options;
  options.image_size = rig.cameras.front().image_size;
  return read(std::span(&base, 1), options, ignored);
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  const std::optional<Rig> old = base != nullptr ? read_base(*base, rig) : std::nullopt;
  const bool edits = old && !options.rewrite && schema::same_cameras(*old, rig);
  if (edits ? !can_store(kFormat, rig, &*old, diagnostics)
            : !writable_alone(kFormat, rig, Message{Code::kNerfDemandsSize}, diagnostics))
    return std::nullopt;
  if (!are_of_one_kind(rig, diagnostics)) return std::nullopt;
  Written written;
  const Rig stated = with_coefficients(rig, edits ? old : std::nullopt, written);
  std::optional<text::Document> document =
      edits ? edited(*base, *old, stated) : text::parse_document({"transforms.json", composed(stated)}, diagnostics);
  if (!document) return std::nullopt;
  const std::string program = program_of(*document);
  written.files.push_back({*std::move(document), {}, {program}});
  for (const Camera& camera : rig.cameras) written.files.front().cameras.push_back(camera.name);
  const std::vector<ExtraField> said = edits ? old->extra_fields : std::vector<ExtraField>();
  add_extras_lost(rig, said, edits ? std::nullopt : old, Message{Code::kNerfNoPlace}, written.losses);
  if (!edits) {
    written.defaults.push_back({.key = std::string(kFrames), .value = Message{Code::kNerfFramesToAdd}, .look_at_it = true});
  }
  list_camera_losses(rig, "nerfstudio", written.losses);
  written.headline = {Code::kNerfHeadline};
  return written;
}

constexpr std::array kModels = {
    StoredModel{"radtan", "OPENCV", true, "nerfstudio; instant-ngp without k3", {}},
    StoredModel{"kb4", "OPENCV_FISHEYE", true, "nerfstudio, instant-ngp", {}},
    StoredModel{"pinhole", "PINHOLE", true, "nerfstudio, instant-ngp", {}},
};
constexpr std::array kOwnFacts = {OwnFact{"images and their poses (frames)"}};
constexpr std::array kDemands = {Demand{"images and their poses", kFrames}};

}  // namespace

const Format kFormat = {
    .id = "nerfstudio",
    .title = "nerfstudio transforms.json",
    .group = FormatGroup::kReconstruction,
    .syntaxes = "JSON",
    .extension = ".json",
    .program = "nerfstudio",
    .main_file = "transforms.json",
    .many_cameras = true,
    .one_model = true,
    .extrinsics = false,
    .imu = false,
    .image_size = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .models = kModels,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::nerfstudio
