// SPDX-License-Identifier: BSD-3-Clause
#include "openvins.h"

#include "../composed.h"
#include "../kalibr/blocks.h"
#include "../kalibr/demands.h"
#include "../kalibr/kalibr.h"
#include "../kalibr/layout.h"
#include "../kalibr/overlaps.h"
#include "../losses.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/text/prose.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace fca::openvins {

using fields::Field;
using text::Node;

namespace {

constexpr std::array kModels = {
    StoredModel{"radtan", "pinhole-radtan", true, "OpenVINS", kalibr::kNoK3, Code::kOpenvinsChainRadtanNoK3},
    StoredModel{"kb4", "pinhole-equidistant", true, "OpenVINS (rays inside 90 deg)", {}},
    StoredModel{"pinhole", "pinhole-radtan with zeros", true, "OpenVINS", {}},
};

constexpr std::array<std::string_view, 1> kOfTheImages = {"line_delay"};
constexpr std::array kOfCameras = {kalibr::kOverlaps};

/// The IMU's own intrinsics: what OpenVINS stops without, and what a calibrated IMU has there.
struct Intrinsic {
  std::string_view key;
  bool identity;
};
constexpr std::array kIntrinsics = {Intrinsic{"Tw", true}, Intrinsic{"R_IMUtoGYRO", true}, Intrinsic{"Ta", true},
                                    Intrinsic{"R_IMUtoACC", true}, Intrinsic{"Tg", false}};

constexpr std::array<std::string_view, 2> kOfTheImu = {"time_offset", "model"};

constexpr auto kImuModelKeys = [] {
  std::array<std::string_view, kIntrinsics.size() + kOfTheImu.size()> keys;
  std::ranges::copy(kOfTheImu, std::ranges::transform(kIntrinsics, keys.begin(), &Intrinsic::key).out);
  return keys;
}();
constexpr std::array kOwnFacts = {OwnFact{"keys of its own (cam_overlaps)"},
                                  OwnFact{"IMU model and intrinsics", kImuModelKeys}};
constexpr std::array kDemands = {Demand{"pose in the IMU", "T_imu_cam"}, Demand{"IMU topic", "rostopic", &Format::imu},
                                 Demand{"IMU intrinsics", "IMU intrinsics", &Format::imu}};

constexpr std::string_view kHeader = "%YAML:1.0";

bool is_opencv_yaml(const text::Document& document) { return document.syntax() == text::Syntax::kOpenCvYaml; }

ProbeResult probe(const text::Document& document) {
  if (!is_opencv_yaml(document)) return {};
  constexpr text::Dialect kDialect = text::Dialect::kOpenCv;
  for (const text::Entry& entry : document.root().entries) {
    const std::string& name = entry.key.value;
    for (const std::string_view key : {"T_imu_cam", "T_cam_imu"}) {
      if (kalibr::index_in(name, "cam") && text::find(entry.value, key, kDialect) != nullptr)
        return {evidence::kCamera + 1, Message{Code::kOpenvinsChainWithKey, {key, name}}};
    }
    if (!kalibr::index_in(name, "imu")) continue;
    for (const Intrinsic& intrinsic : kIntrinsics) {
      if (text::find(entry.value, intrinsic.key, kDialect) != nullptr)
        return {evidence::kPart + 1, Message{Code::kOpenvinsChainWithKey, {intrinsic.key, name}}};
    }
  }
  return {};
}

std::string imu_of(const Rig& rig) { return rig.imus.empty() ? "imu0" : rig.imus.front().name; }

std::optional<Transform> pose_in(const Rig& rig, const std::string& frame, const Camera& camera) {
  const Transform* stated = rig.stated(frame, camera.name);
  return stated != nullptr ? *stated : rig.resolve(frame, camera.name);
}

bool knows_imu_poses(const Rig& rig) {
  return std::ranges::all_of(rig.cameras,
                             [&rig](const Camera& camera) { return pose_in(rig, imu_of(rig), camera).has_value(); });
}

/// T_imu_cam of a camera; where the IMU is not known, in the first camera's frame, as a value to look at.
Transform pose_of(const Rig& rig, const Camera& camera, std::vector<DefaultedValue>& defaults) {
  if (const std::optional<Transform> T = pose_in(rig, imu_of(rig), camera)) return *T;
  const Camera& first = rig.cameras.front();
  const std::optional<Transform> T = pose_in(rig, first.name, camera);
  const bool known = T && first.name != camera.name;
  const Message value = known ? Message{Code::kOpenvinsChainPoseInFrame, {first.name}} : Message{Code::kIdentity};
  defaults.push_back({camera.name + " T_imu_cam", Message{Code::kOpenvinsChainPoseMadeUp, {value}}, true, true});
  return T.value_or(Transform{});
}

/// A fresh chain.
std::optional<text::Document> compose(const Rig& rig, std::vector<ExtraField>& said, std::vector<DefaultedValue>& defaults,
                                      Diagnostics& diagnostics) {
  ComposedYaml chain(std::string(kHeader) + "\n");
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    std::vector<Field> fields = {fields::rows("T_imu_cam", pose_of(rig, camera, defaults))};
    const ExtraField* extra = rig.find_extra_field(camera.name, kalibr::kOverlaps);
    const std::optional<Field> overlaps = kalibr::overlaps_read(rig, camera.name, rig);
    if (overlaps) fields.push_back(*overlaps);
    if (extra != nullptr && kalibr::is_whole(overlaps, *extra)) said.push_back(*extra);
    std::ranges::move(kalibr::lens_fields(camera), std::back_inserter(fields));
    chain.add_comments("\n");
    chain.add_mapping(kalibr::indexed("cam", i), fields, 2);
  }
  return std::move(chain).document("kalibr_imucam_chain.yaml", diagnostics);
}

constexpr std::string_view kImuChain = "kalibr_imu_chain.yaml";

/// That file, if the noise is complete.
void add_imu_file(const Rig& rig, std::vector<ExtraField>& said, Written& written, Diagnostics& diagnostics) {
  Imu imu = rig.imus.front();
  if (const std::vector<std::string> missing = kalibr::missing_in(imu, false); !missing.empty()) {
    const Message why{Code::kCamchainImuDemands, {"OpenVINS", missing}};
    written.losses.push_back(lost(Code::kCamchainImuIncomplete, imu.name, "", {why}));
    return;
  }
  if (imu.topic.empty()) {
    imu.topic = "/" + imu.name;
    written.defaults.push_back({"rostopic (kalibr_imu_chain.yaml)", imu.topic, true, false, std::string(kImuChain)});
  }
  std::string bytes = std::string(kHeader) + "\n\nimu0:\n";
  for (const Field& field : kalibr::imu_fields(imu)) bytes += fields::spell(field, 2) + "\n";
  std::vector<std::string> made_up;
  for (const std::string_view key : kOfTheImu) {
    const ExtraField* read = rig.find_extra_field(imu.name, key);
    bytes += "  " + std::string(key) + ": " + (read != nullptr ? read->value : key == "model" ? "\"kalibr\"" : "0.0") + "\n";
    if (read != nullptr) said.push_back(*read);
  }
  for (const Intrinsic& intrinsic : kIntrinsics) {
    const ExtraField* read = rig.find_extra_field(imu.name, intrinsic.key);
    const std::string one = intrinsic.identity ? "1.0" : "0.0";
    const std::string fresh = "[[" + one + ", 0.0, 0.0], [0.0, " + one + ", 0.0], [0.0, 0.0, " + one + "]]";
    bytes += "  " + std::string(intrinsic.key) + ": " + (read != nullptr ? read->value : fresh) + "\n";
    if (read != nullptr) {
      said.push_back(*read);
    } else {
      made_up.emplace_back(intrinsic.key);
    }
  }
  if (!made_up.empty()) {
    written.defaults.push_back(
        {"IMU intrinsics (" + text::enumerated(made_up) + ")", Message{Code::kOpenvinsChainCalibratedImu}, false});
  }
  if (std::optional<text::Document> document = text::parse_document({std::string(kImuChain), bytes}, diagnostics))
    written.files.push_back({*std::move(document), {}, {"openvins-imu"}});
}

void list_losses(const Rig& rig, std::vector<Loss>& losses) {
  for (const Camera& camera : rig.cameras) {
    if (camera.frame_rate_hz) {
      losses.push_back(lost(Code::kFrameRateDropped, camera.name, "frame rate",
                            {Message{Code::kOpenvinsChainNoKey}, *camera.frame_rate_hz}));
    }
  }
  add_other_time_offsets(rig, rig.cameras.front().time_offset_s.value_or(0.0), Message{Code::kOpenvinsChainOneOffset}, losses);
  for (std::size_t i = 1; i < rig.imus.size(); ++i) {
    losses.push_back(lost(Code::kCamchainImuDropped, rig.imus[i].name, "", {Message{Code::kOpenvinsChainOneImu}}));
  }
  if (rig.baseline_m) losses.push_back(lost(Code::kOpenvinsChainBaselineDropped, "", "baseline", {*rig.baseline_m}));
}

/// The base's own text with what differs, by Kalibr's editor: its layout is the same. Nothing if that cannot be.
std::optional<Written> edited(const text::Document& base, const Rig& old, const Rig& rig, const WriteOptions& options,
                              Diagnostics& diagnostics) {
  const bool same_imus = rig.imus.empty() || rig.imus == old.imus || old.cameras.empty();
  if (!is_opencv_yaml(base) || options.rewrite || (!rig.cameras.empty() && !knows_imu_poses(rig))) return std::nullopt;
  Rig chain = rig;
  if (!rig.cameras.empty()) chain.imus = old.imus;
  Diagnostics said;
  std::optional<Written> written = kalibr::write(&base, chain, options, said);
  if (!written || written->files.front().document.source().bytes != base.source().bytes) return std::nullopt;
  for (const Diagnostic& entry : said.entries()) diagnostics.add(entry);
  written->files.resize(1);
  written->files.front().programs = {rig.cameras.empty() ? "openvins-imu" : "openvins"};
  if (!same_imus) {
    std::vector<ExtraField> ignored;
    add_imu_file(rig, ignored, *written, diagnostics);
  }
  return written;
}

/// An error for every camera whose model OpenVINS takes for another one: camera_model is never read, and every distortion_model
/// but equidistant is radtan (VioManagerOptions.h).
void refuse_misread(const text::Document& document, Diagnostics& diagnostics) {
  fields::Reader reader(document, text::Dialect::kOpenCv, diagnostics);
  for (const text::Entry& entry : document.root().entries) {
    const std::string& name = entry.key.value;
    if (!kalibr::index_in(name, "cam")) continue;
    const Node* model = reader.find(entry.value, "camera_model");
    const Node* distortion = reader.find(entry.value, "distortion_model");
    if (model != nullptr && model->value != "pinhole") {
      reader.say(*model, Code::kOpenvinsChainOtherLens, {name, model->value});
    } else if (distortion != nullptr && distortion->value != "radtan" && distortion->value != "equidistant") {
      reader.say(*distortion, Code::kOpenvinsChainTakenForRadtan, {name, distortion->value});
    }
  }
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  std::optional<Rig> rig = kalibr::read(documents, options, diagnostics);
  for (const text::Document& document : documents) refuse_misread(document, diagnostics);
  return diagnostics.has_errors() ? std::nullopt : rig;
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> old = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  if (rig.cameras.empty() ? rig.imus.empty()
                          : !can_store(kFormat, rig, old && is_opencv_yaml(*base) ? &*old : nullptr, diagnostics)) {
    if (rig.cameras.empty()) diagnostics.add(Code::kCamchainNoCamera, {"an OpenVINS chain"});
    return std::nullopt;
  }
  if (old) {
    if (std::optional<Written> written = edited(*base, *old, rig, options, diagnostics)) {
      if (!rig.cameras.empty()) list_losses(rig, written->losses);
      written->headline = {Code::kOpenvinsChainHeadline};
      return written;
    }
  }
  const Message size_use = {Code::kOpenvinsChainDemandsSize};
  if (!rig.cameras.empty() && !writable_alone(kFormat, rig, size_use, diagnostics)) return std::nullopt;

  Written written;
  std::vector<ExtraField> said;
  if (!rig.cameras.empty()) {
    std::optional<text::Document> document = compose(rig, said, written.defaults, diagnostics);
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {}, {"openvins"}});
    for (const Camera& camera : rig.cameras) written.files.front().cameras.push_back(camera.name);
  }
  if (!rig.imus.empty()) add_imu_file(rig, said, written, diagnostics);
  if (written.files.empty()) {
    diagnostics.add(Code::kCamchainImuNotGiven, {"OpenVINS", kalibr::missing_in(rig.imus.front(), false)});
    return std::nullopt;
  }
  add_beyond_base(rig.extra_fields, said, Message{Code::kOpenvinsChainNoPlace}, written.losses);
  if (base != nullptr) add_rewritten(*base, written.files.front().document, Message{}, written.losses);
  if (old) {
    add_not_carried(extras_beyond(extras_beyond(old->extra_fields, rig.extra_fields), said), Message{Code::kFileRewritten},
                    written.losses);
  }
  if (!rig.cameras.empty()) list_losses(rig, written.losses);
  written.headline = {rig.cameras.empty() ? Code::kOpenvinsChainImuHeadline : Code::kOpenvinsChainHeadline};
  return written;
}

}  // namespace

const Format kFormat = {
    .id = "openvins",
    .title = "OpenVINS chain",
    .syntaxes = "OpenCV YAML",
    .extension = ".yaml",
    .program = "OpenVINS",
    .main_file = "kalibr_imucam_chain.yaml",
    .many_cameras = true,
    .extrinsics = true,
    .imu = true,
    .needs_imu = true,
    .imu_file = true,
    .image_size = true,
    .time_offset = true,
    .topic = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .of_the_images = kOfTheImages,
    .of_cameras = kOfCameras,
    .models = kModels,
    .table = &kalibr::kOpenCvChain,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::openvins
