// SPDX-License-Identifier: BSD-3-Clause
#include "camera_txt.h"
#include "tumvi.h"

#include "../kalibr/blocks.h"
#include "../kalibr/demands.h"
#include "../kalibr/kalibr.h"
#include "../kalibr/overlaps.h"
#include "../losses.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/file_name.h>
#include <fca/formats/text/read_document.h>

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
constexpr std::array<std::string_view, 1> kOfDso = {"DSO's rectified image"};
constexpr std::array kOwnFacts = {OwnFact{"keys of its own (cam_overlaps)"}, OwnFact{kOfDso.front(), kOfDso}};
constexpr std::array kDemands = {Demand{"IMU topic", "rostopic", &Format::imu}};

/// A chain is Kalibr's, and says so.
ProbeResult probe(const text::Document& document) { return probe_camera_txt(document); }

bool is_camera_txt(const text::Document& document) { return document.syntax() == text::Syntax::kWords; }

bool layout_holds(const text::Document& document, std::string_view model) {
  return !is_camera_txt(document) || camera_txt_holds(model);
}

/// The dataset states T_cam_imu and T_cn_cnm1 of one estimate. Where a rig's contradict each other, the chain and the first
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

/// The dataset's images and IMU share one clock, and its chains have no timeshift_cam_imu. A base that states one keeps it.
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
  return base != nullptr && is_camera_txt(*base) && options.extension != ".yaml" && options.extension != ".yml";
}

/// The base, a camera.txt, with the numbers of the rig's one camera. Nothing, and `why` says why, if it cannot say them.
std::optional<text::Document> edited_base(const text::Document& base, const Rig& rig, Message& why) {
  why = problem_with_camera_txt(rig);
  // In shares of the image's size, the base can say another centre than in pixels.
  if (why.is_said() && rig.cameras.size() != 1) return std::nullopt;
  std::optional<text::Document> document = edited_camera_txt(base, rig.cameras.front());
  if (!document && !why.is_said()) why = {Code::kCameraTxtCentreNoShare};
  return document;
}

/// A fresh camera.txt per camera. Nothing, and `why` says why, if one of them cannot be.
std::vector<Written::File> fresh_files(const Rig& rig, Message& why, Diagnostics& diagnostics) {
  std::vector<Written::File> files;
  for (const Camera& camera : rig.cameras) {
    Rig alone;
    alone.cameras = {camera};
    why = problem_with_camera_txt(alone);
    if (why.is_said()) return {};
    const std::string name = rig.cameras.size() == 1 ? "camera.txt" : as_file_name(camera.name) + ".txt";
    std::optional<text::Document> document = text::parse_document({name, fresh_camera_txt(camera)}, diagnostics);
    if (document) files.push_back({*std::move(document), {camera.name}, {"dso"}});
  }
  return files;
}

/// DSO's text: the base with the camera's numbers, or fresh ones. Nothing, and `why` says why, if it cannot say the rig.
std::optional<Written> write_camera_txt(const text::Document* base, const std::optional<Rig>& old, const Rig& rig, Message& why,
                                        Diagnostics& diagnostics) {
  const bool edits = old && is_camera_txt(*base);
  Written written;
  if (edits) {
    std::optional<text::Document> document = edited_base(*base, rig, why);
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {rig.cameras.front().name}, {"dso"}});
  } else {
    written.files = fresh_files(rig, why, diagnostics);
    if (written.files.empty()) return std::nullopt;
    written.defaults.push_back({"rectification (line 3)", "crop", false});
    written.defaults.push_back({"size of DSO's images (line 4)", Message{Code::kCameraTxtSizeOfCamera}, false});
  }
  written.sensor = kLensAlone;
  list_camera_losses(rig, "DSO", written.losses);
  const std::vector<ExtraField> there = edits ? old->extra_fields : std::vector<ExtraField>();
  add_beyond_base(rig.extra_fields, there, Message{Code::kCameraTxtNoPlace}, written.losses);
  written.headline = {written.files.size() == 1 ? Code::kCameraTxtHeadline : Code::kCameraTxtHeadlineEach};
  return written;
}

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() == 1 && is_camera_txt(documents.front())) return read_camera_txt(documents.front(), diagnostics);
  return kalibr::read(documents, options, diagnostics);
}

std::optional<Written> write(const text::Document* base, const Rig& rig_as_named, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const std::optional<Rig> old = options.anew ? std::nullopt : there;
  const auto list_replaced = [&there](const Rig& said, Written& written) {
    add_not_carried(extras_beyond(there->extra_fields, said.extra_fields), Message{Code::kComposedAnew}, written.losses);
  };
  if (wants_camera_txt(base, options)) {
    Message why;
    if (std::optional<Written> written = write_camera_txt(base, old, rig_as_named, why, diagnostics)) {
      if (there && !(old && is_camera_txt(*base))) list_replaced(rig_as_named, *written);
      return written;
    }
    diagnostics.add(Code::kCameraTxtCamchainInstead, {why});
  }
  const text::Document* chain = base != nullptr && !is_camera_txt(*base) ? base : nullptr;
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
