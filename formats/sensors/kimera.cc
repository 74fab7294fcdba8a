// SPDX-License-Identifier: BSD-3-Clause
// Kimera-VIO's parameters of cameras and IMU (MIT-SPARK/Kimera-VIO@ce8c59b of 2025-02: CameraParams.cpp,
// ImuFrontendParams.cpp).
//
//   camera_id                 the camera's name
//   T_BS                      cols, rows, data: 16 numbers row by row, p_body = T p_sensor; the body is the IMU
//   rate_hz                   of the images, read as an int; of the IMU
//   resolution, camera_model, intrinsics, distortion_model, distortion_coefficients   as EuRoC has them; OpenCV undistorts with
//                             4, 5 or 8 coefficients k1 k2 p1 p2 k3 k4 k5 k6, and four stand there even where there are none
//   four noise densities      as EuRoC has them
//   imu_time_shift            t_imu = t_cam + shift, for all cameras
//   imu_preintegration_type, imu_bias_init_sigma, ...   tune the program
//
// Kimera-VIO stops where one of these keys is missing; further ones are ignored (those of a depth camera).
#include "kimera.h"

#include "../losses.h"
#include "files.h"
#include "keys.h"

#include <fca/formats/file_name.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>

namespace fca::kimera {

using schema::FactKind;
using schema::Key;
using schema::required;
using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

constexpr std::array<ParameterId, 5> kRadtanK3 = {"k1", "k2", "p1", "p2", "k3"};
constexpr std::array<ParameterId, 8> kRational = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};

/// Rows of the three names of one lens.
constexpr std::array<schema::ListLens, 3> opencv_lenses(std::string_view name) {
  return {{{"radtan", "pinhole", name, sensors::kRadtan, 0, sensors::kNoK3},
           {"radtan", "pinhole", name, kRadtanK3},
           {"rational", "pinhole", name, kRational}}};
}
constexpr auto kLenses = [] {
  std::array<schema::ListLens, 12> lenses{};
  auto* at = std::ranges::copy(opencv_lenses("radial-tangential"), lenses.data()).out;
  *at++ = {"kb4", "pinhole", "equidistant", sensors::kEquidistant};
  *at++ = {"pinhole", "pinhole", "none", {}, 4, {}, true};
  at = std::ranges::copy(opencv_lenses("radtan"), at).out;  // these are read only
  at = std::ranges::copy(opencv_lenses("plumb_bob"), at).out;
  *at = {"pinhole", "omni", "omni", {}, 0, {}, true, Code::kKimeraOmni};
  return lenses;
}();

/// As FileNode's conversion to int: the nearest, of two the even one.
int whole_rate(double rate_hz) { return static_cast<int>(std::lrint(std::min(rate_hz, 1e6))); }

bool read_rate(schema::Reading& reading, const Key& key, const Node& node) {
  if (!schema::read_frame_rate(reading, key, node)) return false;
  const double rate = reading.camera->frame_rate_hz.value();
  if (rate != std::floor(rate))
    reading.reader.say(node, Code::kKimeraRateNotWhole, {reading.label(key), rate, whole_rate(rate)});
  return true;
}

constexpr int kStockRate = 20;

std::vector<Statement> write_rate(const Subject& subject, const Key& key) {
  const Camera& camera = subject.the_camera();
  if (!camera.frame_rate_hz && subject.fresh == nullptr) return {};
  if (!camera.frame_rate_hz) {
    subject.fresh->defaults.push_back(
        {camera.name + " " + key.text(), Message{Code::kKimeraInitialValue, {kStockRate}}, true, false});
  }
  const int rate = std::max(1, whole_rate(camera.frame_rate_hz.value_or(kStockRate)));
  return schema::states(fields::integer(key.text(), rate), {FactKind::kFrameRate});
}

constexpr std::string_view kShift = "imu_time_shift";

/// Kept for the cameras, which other files specify. Zero says nothing.
bool read_shift(schema::Reading& reading, const Key& key, const Node& node) {
  const std::optional<double> shift = reading.reader.time_offset(node, reading.label(key));
  if (shift && *shift != 0.0) reading.rig.extra_fields.push_back({reading.imu->name, key.text(), node.value});
  return shift.has_value();
}

const ExtraField* find_shift(const Rig& rig) {
  const auto found = std::ranges::find(rig.extra_fields, kShift, &ExtraField::key);
  return found == rig.extra_fields.end() ? nullptr : &*found;
}

/// An edit leaves it where the rig says nothing of it.
std::vector<Statement> write_shift(const Subject& subject, const Key& key) {
  const auto stated =
      std::ranges::find_if(subject.rig.cameras, [](const Camera& camera) { return camera.time_offset_s.has_value(); });
  if (stated == subject.rig.cameras.end() && subject.fresh == nullptr) return {};
  const ExtraField* kept = find_shift(subject.rig);
  const double from_file = kept != nullptr ? text::parse_real(kept->value).value_or(0.0) : 0.0;
  const double shift = stated != subject.rig.cameras.end() ? *stated->time_offset_s : from_file;
  return schema::states(fields::real(key.text(), shift), {FactKind::kTimeOffset});
}

constexpr Key tuning(std::string_view name, std::string_view token) { return schema::tuning(name, "kimera.", token); }

constexpr std::array kCameraKeys = {
    schema::camera_name("camera_id"),
    required(schema::camera_model("camera_model", kLenses)),
    required(schema::distortion_model("distortion_model", "camera_model", "distortion_coefficients", kLenses)),
    required(schema::focal_and_centre("intrinsics")),
    required(schema::coefficients("distortion_coefficients", kLenses)),
    schema::image_size("resolution"),
    Key{"rate_hz", FactKind::kFrameRate, read_rate, write_rate},
    schema::object("T_BS", sensors::kPose),
};
constexpr std::array<std::string_view, kCameraKeys.size()> kCameraOrder = {
    "camera_id", "T_BS", "rate_hz", "resolution", "camera_model", "intrinsics", "distortion_model", "distortion_coefficients"};

/// Noise, rate and tuning begin as the program's params/Euroc/ImuParams.yaml has them.
constexpr std::array kImuHead = {tuning("imu_preintegration_type", "1"), schema::object("T_BS", sensors::kIdentity),
                                 schema::imu_number("rate_hz", &Imu::rate_hz, 200.0), tuning("imu_bias_init_sigma", "1.0e-3")};
constexpr std::array kImuTail = {
    tuning("do_imu_rate_time_alignment", "1"),
    tuning("time_alignment_window_size_s", "10.0"),
    tuning("time_alignment_variance_threshold_scaling", "30.0"),
    tuning("imu_integration_sigma", "1.0e-8"),
    Key{kShift, FactKind::kTimeOffset, read_shift, write_shift},
    tuning("n_gravity", "[0.0, 0.0, -9.81]"),
};
constexpr auto kImuKeys = sensors::joined(kImuHead, sensors::noise_keys({1.6968e-4, 1.9393e-5, 2.0e-3, 3.0e-3}), kImuTail);
constexpr auto kAllKeys = sensors::joined(kCameraKeys, kImuKeys);

constexpr schema::Schema schema_of(const schema::Mapping& root) {
  return {.what = "a file of Kimera-VIO",
          .dialect = text::Dialect::kOpenCv,
          .root = root,
          .codes = sensors::kCodes,
          .program = "Kimera-VIO"};
}
constexpr schema::Schema kCameraTable = schema_of({.keys = kCameraKeys,
                                                   .written = kCameraOrder,
                                                   .unread = "",
                                                   .warns_of_duplicates = true,
                                                   .stops_at_error = true,
                                                   .missing = Code::kTableMissingKeys});
constexpr schema::Schema kImuTable = schema_of(
    {.keys = kImuKeys, .unread = "", .warns_of_duplicates = true, .stops_at_error = true, .missing = Code::kTableMissingKeys});
constexpr schema::Schema kTable = schema_of({.keys = kAllKeys});

std::string first_camera(const text::Document& /*document*/) { return "cam0"; }
std::string imu_name(const text::Document& /*document*/) { return std::string(schema::kImu); }

constexpr std::array<std::string_view, 2> kCameraFiles = {"LeftCameraParams.yaml", "RightCameraParams.yaml"};

/// A file that is edited keeps its place among them.
std::string camera_place(const Rig& rig, std::size_t camera, const text::Document* base) {
  const std::string own = base != nullptr ? std::filesystem::path(base->source().name).filename().string() : "";
  if (std::ranges::find(kCameraFiles, own) != kCameraFiles.end()) return own;
  const bool is_of_pair = camera == 0 || (camera == 1 && may_be_stereo(rig, rig.cameras[0], rig.cameras[1]));
  if (is_of_pair) return std::string(kCameraFiles.at(camera));
  return as_file_name(rig.cameras[camera].name) + "CameraParams.yaml";
}

const sensors::Files& files() {
  static const sensors::Files kFiles = {.format = kFormat,
                                        .camera = kCameraTable,
                                        .imu = kImuTable,
                                        .whole = kTable,
                                        .file_of = "Kimera-VIO",
                                        .wrote = Code::kKimeraWrote,
                                        .wrote_imu = Code::kKimeraWroteImu,
                                        .camera_name = first_camera,
                                        .imu_name = imu_name,
                                        .camera_place = camera_place,
                                        .imu_place = "ImuParams.yaml",
                                        .camera_program = "kimera",
                                        .imu_program = "kimera-imu",
                                        .demands_imu = true};
  return kFiles;
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  return sensors::read(files(), documents, options, diagnostics);
}

/// The time shift of ImuParams.yaml is that of all cameras. Next to a camera that specifies another one it stays a field of its
/// own, which is listed where it is not written.
void complete(Rig& rig) {
  const ExtraField* field = find_shift(rig);
  if (field == nullptr || rig.cameras.empty()) return;
  const std::optional<double> shift = text::parse_real(field->value);
  for (Camera& camera : rig.cameras) {
    if (!camera.time_offset_s) camera.time_offset_s = shift;
  }
  if (std::ranges::any_of(rig.cameras, [&shift](const Camera& camera) { return camera.time_offset_s != shift; })) return;
  std::erase_if(rig.extra_fields, [](const ExtraField& extra) { return extra.key == kShift; });
}

/// What a file has room for, but not as it is.
void list_losses(const text::Document* base, const Rig& rig, Written& written) {
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  for (const Camera& camera : rig.cameras) {
    const double rate = camera.frame_rate_hz.value_or(kStockRate);
    const bool kept = there && !there->cameras.empty() && there->cameras.front().frame_rate_hz == camera.frame_rate_hz;
    const int whole = std::max(1, whole_rate(rate));
    if (rate != whole && !kept)
      written.losses.push_back(lost(Code::kKimeraFrameRateRounded, camera.name, "rate_hz", {rate, whole}));
  }
  const bool imu_file = written.files.back().cameras.empty();
  for (const Camera& camera : rig.cameras) {
    if (!imu_file) add_time_offset(camera, Message{Code::kKimeraNoImuFile}, written.losses);
  }
}

/// Kimera-VIO takes LeftCameraParams.yaml and RightCameraParams.yaml for a stereo pair, the left one alone for a monocular
/// camera, and opens no further camera's file.
void report_pair(const Rig& rig, Written& written) {
  const Camera& left = rig.cameras[0];
  const Camera& right = rig.cameras[1];
  const bool is_pair = may_be_stereo(rig, left, right);
  std::vector<std::string> unread;
  for (const Camera& camera : std::span(rig.cameras).subspan(is_pair ? 2 : 1)) unread.push_back(camera.name);
  std::vector<Message> others;
  if (!unread.empty()) others.push_back({Code::kKimeraOpensNone, {unread}});
  if (is_pair) {
    written.headline = {Code::kKimeraWrotePair, {written.headline, left.name, right.name, others}};
    written.first_is_left = {Code::kKimeraFirstIsLeft};
  } else {
    written.headline = {Code::kKimeraWroteOne, {written.headline, left.name, right.name, others}};
  }
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  std::optional<Written> written = sensors::write(files(), base, rig, options, diagnostics);
  if (!written) return written;
  list_losses(base, rig, *written);
  if (rig.cameras.size() > 1) report_pair(rig, *written);
  return written;
}

ProbeResult probe(const text::Document& document) {
  const Node& root = document.root();
  const auto has = [&root](std::string_view key) { return text::find(root, key, kTable.dialect) != nullptr; };
  const auto found = [](std::string_view a, std::string_view b) {
    return Message{Code::kFoundKeys, {std::vector<std::string>{std::string(a), std::string(b)}}};
  };
  for (const std::string_view key : {"camera_model", "distortion_model", "T_BS", "intrinsics"}) {
    if (has("camera_id") && has(key)) return {evidence::kCamera, found("camera_id", key)};
  }
  for (const std::string_view key :
       {"imu_preintegration_type", "imu_integration_sigma", "n_gravity", "imu_bias_init_sigma", "imu_time_shift"}) {
    if (!has(key)) continue;
    if (sensors::is_imu(root)) return {evidence::kCamera, found(key, "noise densities")};
    if (has("T_BS") || has("rate_hz")) return {evidence::kHint, found(key, has("T_BS") ? "T_BS" : "rate_hz")};
  }
  return {};
}

constexpr std::string_view kReader = "Kimera-VIO";
constexpr std::string_view kUndistorts = "Kimera-VIO (its projection takes the first four coefficients)";
constexpr std::array kModels = {
    StoredModel{"radtan", "radial-tangential", true, kReader, {}},
    StoredModel{"kb4", "equidistant", true, kReader, {}},
    StoredModel{"rational", "radial-tangential with 8", true, kUndistorts, {}},
    StoredModel{"pinhole", "none", true, kReader, {}},
};
constexpr std::array kOwnFacts = {OwnFact{"tuning and keys of a depth camera"}};
constexpr std::array kDemands = {
    Demand{"pose in the IMU", "T_BS"},
    Demand{"IMU noise", "_noise_density", nullptr, &Format::needs_imu},
    Demand{"IMU random walks", "_random_walk", nullptr, &Format::needs_imu},
    Demand{"IMU rate", "IMU rate_hz", nullptr, &Format::needs_imu},
    Demand{"frame rate", " rate_hz", nullptr, &Format::frame_rate},
    Demand{"Kimera's tuning", "tuning ("},
};

}  // namespace

const Format kFormat = {
    .id = "kimera",
    .title = "Kimera-VIO parameters",
    .syntaxes = "YAML",
    .extension = ".yaml",
    .program = "Kimera-VIO",
    .main_file = "LeftCameraParams.yaml",
    .many_cameras = false,
    .begins_with_pair = true,
    .extrinsics = true,
    .imu = true,
    .needs_imu = true,
    .imu_file = true,
    .image_size = true,
    .time_offset = true,
    .frame_rate = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .models = kModels,
    .table = &kTable,
    .probe = probe,
    .complete = complete,
    .read = read,
    .write = write,
};

}  // namespace fca::kimera
