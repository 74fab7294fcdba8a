// SPDX-License-Identifier: BSD-3-Clause
#include "tumvi.h"

#include "../dso/camera_txt.h"
#include "../dso/dso.h"
#include "../kalibr/blocks.h"
#include "../kalibr/demands.h"
#include "../kalibr/kalibr.h"
#include "../kalibr/overlaps.h"
#include "../losses.h"

#include <fca/code.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::tumvi {

namespace {

/// What Kalibr holds. The dataset has two calibrations of its cameras, and their models stand first.
constexpr std::array kModels = {
    StoredModel{"kb4", "pinhole-equidistant", true, "Kalibr (rays inside 90 deg), DSO (camera.txt)", {}},
    StoredModel{"mei", "omni-radtan", true, "Kalibr", {}},
    StoredModel{"radtan", "pinhole-radtan", true, "Kalibr, DSO (camera.txt)", kalibr::kNoK3, Code::kCamchainRadtanNoK3},
    StoredModel{"eucm", "eucm-none", true, "Kalibr", kalibr::kAlphaRange, Code::kCamchainAlphaBelowOne},
    StoredModel{"ds", "ds-none", true, "Kalibr", kalibr::kAlphaRange, Code::kCamchainAlphaBelowOne},
    StoredModel{"ucm", "eucm-none with beta = 1", true, "Kalibr", kalibr::kAlphaRange, Code::kCamchainAlphaBelowOne},
    StoredModel{"fov", "pinhole-fov", true, "Kalibr (w in [0.5, 1.5]), DSO (camera.txt)", {}},
    StoredModel{"pinhole", "pinhole-radtan with zeros", true, "Kalibr, DSO (camera.txt)", {}},
};

constexpr std::array<std::string_view, 1> kOfTheImages = {"line_delay"};
constexpr std::array kOfCameras = {kalibr::kOverlaps};
constexpr std::array kOwnFacts = {OwnFact{"keys of its own (cam_overlaps)"}};
constexpr std::array kDemands = {Demand{"IMU topic", "rostopic", &Format::imu}};

/// A chain is Kalibr's, and says so, and a camera.txt is DSO's.
ProbeResult probe(const text::Document& /*document*/) { return {}; }

bool layout_holds(const text::Document& document, std::string_view model) {
  return !dso::is_camera_txt(document) || dso::camera_txt_holds(model);
}

/// The dataset specifies T_cam_imu and T_cn_cnm1 of one estimate. Where a rig's contradict each other, the chain and the first
/// camera's pose are kept, and the others follow from them.
void make_consistent(Rig& rig, std::vector<Loss>& losses, std::vector<PoseEdge>& restated) {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 1; i < rig.cameras.size(); ++i) {
    const std::string& name = rig.cameras[i].name;
    const Transform* stated = rig.stated(name, "imu0");
    const Transform* chain = rig.stated(name, rig.cameras[i - 1].name);
    const std::optional<Transform> before = rig.resolve(rig.cameras[i - 1].name, "imu0");
    if (stated == nullptr || chain == nullptr || !before) continue;
    const Transform derived = *chain * *before;
    double worst = 0.0;
    for (std::size_t k = 0; k < derived.values.size(); ++k)
      worst = std::max(worst, std::abs(derived.values[k] - stated->values[k]));
    if (worst <= kRounding) continue;
    losses.push_back(lost(Code::kTumviPoseRecomputed, name, "T_cam_imu", {rig.cameras[i - 1].name, worst}));
    std::erase_if(rig.poses, [&name](const PoseEdge& edge) { return edge.a == name && edge.b == "imu0"; });
    rig.poses.push_back({name, "imu0", derived});
    restated.push_back(rig.poses.back());
  }
}

/// The dataset's images and IMU share one clock, and its chains have no timeshift_cam_imu. A base that specifies one keeps it.
void remove_time_offsets(Rig& rig, const Rig* old, std::vector<Loss>& losses) {
  for (Camera& camera : rig.cameras) {
    const Camera* before = old != nullptr ? old->find_camera(camera.name) : nullptr;
    if (before != nullptr && before->time_offset_s == camera.time_offset_s) continue;
    add_time_offset(camera, Message{Code::kTumviHasNoTimeOffset}, losses);
    camera.time_offset_s.reset();
  }
}

/// Is DSO's text asked for: by the name of the file to be written, or by the base where that name says nothing else?
bool wants_camera_txt(const text::Document* base, const WriteOptions& options) {
  if (options.extension == ".txt") return true;
  return base != nullptr && dso::is_camera_txt(*base) && options.extension != ".yaml" && options.extension != ".yml";
}

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() == 1 && dso::is_camera_txt(documents.front()))
    return dso::read_camera_txt(documents.front(), diagnostics);
  return kalibr::read(documents, options, diagnostics);
}

std::optional<Written> write(const text::Document* base, const Rig& rig_as_named, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const std::optional<Rig> old = options.rewrite ? std::nullopt : there;
  const auto list_replaced = [&there](const Rig& said, Written& written) {
    add_not_carried(extras_beyond(there->extra_fields, said.extra_fields), Message{Code::kFileRewritten}, written.losses);
  };
  if (wants_camera_txt(base, options)) {
    Message why;
    const bool edits = old && dso::is_camera_txt(*base);
    if (edits && rig_as_named.cameras.size() != 1) why = {Code::kCameraTxtManyCameras, {rig_as_named.cameras.size()}};
    std::optional<Written> written = why.is_said() ? std::nullopt : dso::written(base, old, rig_as_named, why, diagnostics);
    if (written) {
      if (there && !edits) list_replaced(rig_as_named, *written);
      return written;
    }
    diagnostics.add(Code::kCameraTxtCamchainInstead, {why});
  }
  const text::Document* chain = base != nullptr && !dso::is_camera_txt(*base) ? base : nullptr;
  const bool own_chain = chain != nullptr && !options.adopted;
  Rig rig = rig_as_named;
  std::vector<Loss> losses;
  std::vector<PoseEdge> restated;
  remove_time_offsets(rig, own_chain && old ? &*old : nullptr, losses);
  if (!own_chain) make_consistent(rig, losses, restated);
  std::optional<Written> written = kalibr::write(chain, rig, options, diagnostics);
  if (!written) return std::nullopt;
  written->losses.insert(written->losses.begin(), losses.begin(), losses.end());
  written->restated = std::move(restated);
  if (there && chain == nullptr) list_replaced(rig, *written);
  written->headline = {Code::kTumviHeadline};
  return written;
}

const Format kFormat = {
    .id = "tumvi",
    .title = "TUM-VI calibration",
    .group = FormatGroup::kDatasets,
    .syntaxes = "YAML, text",
    .extension = ".yaml",
    .program = "Kalibr",
    .layout_of = "kalibr",
    .many_cameras = true,
    .extrinsics = true,
    .imu = true,
    .image_size = true,
    .topic = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .of_the_images = kOfTheImages,
    .of_cameras = kOfCameras,
    .models = kModels,
    .table = &kalibr::kChain,
    .probe = probe,
    .layout_holds = layout_holds,
    .read = read,
    .write = write,
};

}  // namespace fca::tumvi
