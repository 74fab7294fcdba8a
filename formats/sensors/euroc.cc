// SPDX-License-Identifier: BSD-3-Clause
// EuRoC's sensor.yaml (the ASL dataset format), and cuVSLAM's dialect of it (PyCuVSLAM@f1fb2b8, examples/euroc).
//
//   sensor_type, comment      say nothing
//   T_BS                      cols, rows, data: 16 numbers row by row, p_body = T p_sensor; the body is the IMU
//   T_Cam0                    cuVSLAM's: p_cam0 = T p_sensor
//   rate_hz                   of the images, of the IMU
//   resolution                [width, height]
//   camera_model, intrinsics  pinhole, [fu, fv, cu, cv]
//   distortion_model, distortion_coefficients  radial-tangential [k1, k2, p1, p2], equidistant [k1, k2, k3, k4]
//   gyroscope_noise_density, gyroscope_random_walk, accelerometer_noise_density, accelerometer_random_walk   densities in SI
//   units
//
// cuVSLAM's example has files with camera_model fisheye: their numbers are equidistant, though distortion_model says
// radial-tangential. Which sensor a file is of its path says, if it says it at all: cam1/sensor.yaml, sensor_cam1.yaml. There
// is no key for a time offset.
#include "euroc.h"

#include "../name_in_path.h"
#include "cuvslam_rig.h"
#include "files.h"
#include "keys.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <set>

namespace fca::euroc {

using schema::only_edited;
using schema::required;
using text::Node;

namespace {

constexpr std::string_view kBody = "T_BS";
constexpr std::string_view kFirstCamera = "T_Cam0";

constexpr schema::ListLens kLenses[] = {
    {"radtan", "pinhole", "radial-tangential", sensors::kRadtan, 0, sensors::kNoK3},
    {"kb4", "pinhole", "equidistant", sensors::kEquidistant},
    {"pinhole", "pinhole", "radial-tangential", {}, 4},
    // Read only.
    {"pinhole", "pinhole", "none", {}, 0, {}, true},
    {"radtan", "pinhole", "radtan", sensors::kRadtan, 0, sensors::kNoK3},
    {"radtan", "pinhole", "plumb_bob", sensors::kRadtan, 0, sensors::kNoK3},
    {"kb4", "fisheye", "equidistant", sensors::kEquidistant},
    {"kb4", "fisheye", "radial-tangential", sensors::kEquidistant, 0, {}, false, Code::kEurocFisheye},
};

constexpr schema::PoseLayout kPoseInCam0 = {.frame = "cam0", .kind = FrameKind::kOther, .translation = {}, .rotation = {}};
constexpr std::array kCam0Keys = {schema::side_of_four("cols"), schema::side_of_four("rows"),
                                  required(schema::matrix("data", kFirstCamera, kPoseInCam0))};
constexpr schema::Mapping kCam0 = {.keys = kCam0Keys};
constexpr std::array kImuInCam0Keys = {schema::side_of_four("cols"), schema::side_of_four("rows"),
                                       required(schema::imu_matrix("data", kPoseInCam0))};
constexpr schema::Mapping kImuInCam0 = {.keys = kImuInCam0Keys};

constexpr std::array kCameraKeys = {
    schema::fixed("sensor_type", "camera"),
    required(schema::camera_model("camera_model", kLenses)),
    required(schema::distortion_model("distortion_model", "camera_model", "distortion_coefficients", kLenses)),
    required(schema::focal_and_centre("intrinsics")),
    required(schema::coefficients("distortion_coefficients", kLenses)),
    schema::image_size("resolution"),
    schema::frame_rate("rate_hz"),
    schema::object(kBody, sensors::kPose),
    only_edited(schema::object(kFirstCamera, kCam0)),
    schema::unread("camera_id"),  // Kimera's, misspelt
};
constexpr std::array<std::string_view, 8> kCameraOrder = {
    "sensor_type", kBody, "rate_hz", "resolution", "camera_model", "intrinsics", "distortion_model", "distortion_coefficients"};

constexpr std::array kImuHead = {schema::fixed("sensor_type", "imu"), schema::object(kBody, sensors::kIdentity),
                                 only_edited(schema::object(kFirstCamera, kImuInCam0)),
                                 schema::imu_number("rate_hz", &Imu::rate_hz)};
constexpr auto kImuKeys = sensors::joined(kImuHead, sensors::noise_keys({}));
constexpr auto kAllKeys = sensors::joined(kCameraKeys, kImuKeys);

constexpr schema::Schema schema_of(const schema::Mapping& root) {
  return {.what = "a sensor.yaml", .dialect = text::Dialect::kPyYaml, .root = root, .codes = sensors::kCodes};
}
constexpr schema::Schema kCameraTable = schema_of(
    {.keys = kCameraKeys, .written = kCameraOrder, .unread = "", .warns_of_duplicates = true, .stops_at_error = true});
constexpr schema::Schema kImuTable =
    schema_of({.keys = kImuKeys, .unread = "", .warns_of_duplicates = true, .stops_at_error = true});
constexpr schema::Schema kTable = schema_of({.keys = kAllKeys});

const Node* numbers_at(const Node& root, std::string_view key) {
  const Node* pose = text::find(root, key, kTable.dialect);
  return pose != nullptr ? text::find(*pose, "data", kTable.dialect) : nullptr;
}

/// Of a camera that is not where cam0 is, cam1.
std::string camera_name(const text::Document& document) {
  const std::string name = name_by_path(document.source().name, "cam");
  if (!name.empty()) return name;
  const Node* data = numbers_at(document.root(), kFirstCamera);
  Transform T;
  for (std::size_t i = 0; data != nullptr && i < std::min(data->items.size(), T.values.size()); ++i)
    T.values.at(i) = text::parse_real(data->items[i].value).value_or(T.values.at(i));
  return T == Transform{} ? "cam0" : "cam1";
}

std::string imu_name(const text::Document& document) {
  const std::string name = name_by_path(document.source().name, "imu");
  return name.empty() ? std::string(schema::kImu) : name;
}

/// By the cameras' names where all are called so, else counted.
std::string camera_place(const Rig& rig, std::size_t camera, const text::Document* /*base*/) {
  std::set<std::string> names;
  for (const Camera& each : rig.cameras) {
    if (indexed_name(each.name, "cam") == each.name) names.insert(each.name);
  }
  const bool all = names.size() == rig.cameras.size();
  return "mav0/" + (all ? rig.cameras[camera].name : "cam" + std::to_string(camera)) + "/sensor.yaml";
}

const sensors::Files& files() {
  static const sensors::Files kFiles = {.format = kFormat,
                                        .camera = kCameraTable,
                                        .imu = kImuTable,
                                        .whole = kTable,
                                        .file_of = "EuRoC",
                                        .wrote = Code::kEurocWrote,
                                        .wrote_imu = Code::kEurocWroteImu,
                                        .camera_name = camera_name,
                                        .imu_name = imu_name,
                                        .camera_place = camera_place,
                                        .imu_place = "mav0/imu0/sensor.yaml",
                                        .camera_program = "cuvslam",
                                        .imu_program = "cuvslam-imu",
                                        .imu_demands = Code::kEurocImuDemands};
  return kFiles;
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (cuvslam_rig::is_rig(documents.front())) return cuvslam_rig::read(documents.front(), diagnostics);
  return sensors::read(files(), documents, options, diagnostics);
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  const bool is_rig_file = base != nullptr && cuvslam_rig::is_rig(*base);
  if (std::optional<Written> edited = is_rig_file && !options.rewrite ? cuvslam_rig::edited(*base, rig) : std::nullopt)
    return edited;
  std::optional<Written> written = sensors::write(files(), is_rig_file ? nullptr : base, rig, options, diagnostics);
  const auto is_equidistant = [](const Camera& camera) { return model_info(camera.model).id == "kb4"; };
  if (written && std::ranges::any_of(rig.cameras, is_equidistant))
    diagnostics.add(Code::kCuvslamSaysTakenForBrown, {"distortion_model", "equidistant"});
  return written;
}

ProbeResult probe(const text::Document& document) {
  if (const ProbeResult rig = cuvslam_rig::probe(document); rig.score > 0) return rig;
  const Node& root = document.root();
  const auto has = [&root](std::string_view key) { return text::find(root, key, kTable.dialect) != nullptr; };
  // Kimera's own.
  if (has("camera_id") || has("imu_preintegration_type") || has("imu_integration_sigma") || has("n_gravity")) return {};
  const auto found = [](std::string_view a, std::string_view b) {
    return Message{Code::kFoundKeys, {std::vector<std::string>{std::string(a), std::string(b)}}};
  };
  for (const std::string_view head : {kBody, kFirstCamera, std::string_view("sensor_type")}) {
    if (!has(head)) continue;
    if (sensors::is_imu(root)) return {evidence::kCamera, found(head, "noise densities")};
    for (const std::string_view key : {"intrinsics", "camera_model", "distortion_coefficients"}) {
      if (has(key)) return {evidence::kCamera, found(head, key)};
    }
    if (has("rate_hz")) return {evidence::kHint, found(head, "rate_hz")};
  }
  return {};
}

constexpr std::array kModels = {
    StoredModel{"radtan", "radial-tangential", true, "cuVSLAM", sensors::kNoK3Range, Code::kEurocNoK3},
    StoredModel{"kb4", "equidistant", true, "cuVSLAM (named sensor_recalibrated.yaml)", {}},
    StoredModel{"pinhole", "radial-tangential with zeros", true, "cuVSLAM", {}},
};
constexpr std::array kOwnFacts = {OwnFact{"keys of its own (comment)"}};
constexpr std::array kDemands = {Demand{"pose in the IMU", "T_BS"}};

}  // namespace

const Format kFormat = {
    .id = "euroc",
    .title = "EuRoC sensor.yaml",
    .group = FormatGroup::kDatasets,
    .syntaxes = "YAML",
    .extension = ".yaml",
    .program = "cuVSLAM",
    .main_file = "sensor.yaml",
    .many_cameras = false,
    .extrinsics = true,
    .imu = true,
    .needs_imu = true,
    .imu_file = true,
    .image_size = true,
    .frame_rate = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .models = kModels,
    .table = &kTable,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::euroc
