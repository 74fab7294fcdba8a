// SPDX-License-Identifier: BSD-3-Clause
// Basalt's calibration JSON (VladyslavUsenko/basalt-headers, serialization/headers_serialization.h and
// calibration/calibration.hpp).
//
//   value0
//     intrinsics          per camera: camera_type and, below a second "intrinsics", its parameters by name
//     T_imu_cam           per camera: px py pz [m], qx qy qz qw: p_imu = T p_cam
//     resolution          per camera: [w, h]
//     cam_time_offset_ns  one for all cameras: t_imu = t_cam + offset
//     imu_update_rate     Hz
//     gyro_noise_std, accel_noise_std, gyro_bias_std, accel_bias_std   continuous-time densities, one number per axis
//     calib_accel_bias    9: bias and six elements of scale; calib_gyro_bias 12: bias and nine
//     vignette            a spline per camera, or none
//
// Basalt stops where one of these keys is missing; their order is free and further keys are ignored (T_mocap_world, ...).
// Versions before 2020 had one number for each noise. Those since 2022 read pinhole-radtan8.
#include "basalt.h"

#include "losses.h"
#include "one_camera_files.h"
#include "schema/keys.h"

#include <fca/code.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>

namespace fca::basalt {

using schema::per_camera;
using schema::required;
using schema::Spread;
using text::Node;

namespace {

/// The largest radius x^2 + y^2 = rpmax^2 of pinhole-radtan8; -1: none. It has no place in our model.
constexpr std::string_view kMaxRadius = "rpmax";
constexpr std::string_view kVignette = "vignette";

/// Parameters have the same names as ours.
constexpr schema::Lens kLenses[] = {{"ds", "ds"},
                                    {"kb4", "kb4"},
                                    {"eucm", "eucm"},
                                    {"ucm", "ucm"},
                                    {"fov", "fov"},
                                    {"pinhole", "pinhole"},
                                    {"pinhole-radtan8", "rational", kMaxRadius, -1.0}};

constexpr std::array<std::string_view, 3> kTranslation = {"px", "py", "pz"};
constexpr std::array<std::string_view, 4> kRotation = {"qx", "qy", "qz", "qw"};
constexpr schema::PoseLayout kPoseInImu = {.frame = schema::kImu,
                                           .kind = FrameKind::kImu,
                                           .translation = kTranslation,
                                           .rotation = kRotation,
                                           .shortest = 0.95,
                                           .longest = 1.05,
                                           .no_pose = Code::kBasaltNoPose,
                                           .wrong_length = Code::kBasaltQuaternionLength,
                                           .zero_length = Code::kBasaltQuaternionZero,
                                           .restated = Code::kBasaltPoseRecomputed,
                                           .in_frame = Code::kBasaltPoseInFrame,
                                           .identity = Code::kBasaltIdentity};

constexpr std::array kCameraKeys = {required(schema::lens_name("camera_type", kLenses)),
                                    required(schema::parameters("intrinsics", kLenses))};
constexpr schema::Mapping kCamera = {.keys = kCameraKeys};

/// Noise and rate begin as calibration.hpp has it, "reasonable defaults".
constexpr std::array kKeys = {
    required(per_camera(Spread::kCounted, schema::object("intrinsics", kCamera))),
    per_camera(Spread::kEach, schema::image_size("resolution")),
    per_camera(Spread::kEach, schema::pose("T_imu_cam", kPoseInImu)),
    per_camera(Spread::kSomeEach, schema::kept(kVignette)),
    schema::density("accel_noise_std", &Imu::accelerometer_noise_density, 3, 0.016),
    schema::density("gyro_noise_std", &Imu::gyroscope_noise_density, 3, 0.000282),
    schema::density("accel_bias_std", &Imu::accelerometer_random_walk, 3, 0.001),
    schema::density("gyro_bias_std", &Imu::gyroscope_random_walk, 3, 0.0001),
    schema::imu_number("imu_update_rate", &Imu::rate_hz, 200.0),
    schema::kept_numbers("calib_accel_bias", 9),
    schema::kept_numbers("calib_gyro_bias", 12),
    schema::common_time_offset("cam_time_offset_ns", 1e9),
};
constexpr std::array<std::string_view, kKeys.size()> kWrittenOrder = {
    "T_imu_cam",       "intrinsics",     "resolution",     "calib_accel_bias", "calib_gyro_bias",    "imu_update_rate",
    "accel_noise_std", "gyro_noise_std", "accel_bias_std", "gyro_bias_std",    "cam_time_offset_ns", "vignette"};
constexpr schema::Mapping kValue = {
    .keys = kKeys, .written = kWrittenOrder, .unread = "", .warns_of_duplicates = true, .missing = Code::kBasaltMissingKeys};
constexpr std::array kRootKeys = {required(schema::object("value0", kValue))};

/// cereal looks a key up from the front: of equal ones the first counts, as in cv::FileStorage.
constexpr schema::Schema kSchema = {.what = "a Basalt calibration",
                                    .dialect = text::Dialect::kOpenCv,
                                    .root = {.keys = kRootKeys},
                                    .codes = {.wrong_syntax = Code::kBasaltWrongSyntax,
                                              .no_object = Code::kBasaltNoObject,
                                              .no_camera_list = Code::kBasaltNoCameraList,
                                              .no_list = Code::kBasaltNoList,
                                              .item_count = Code::kBasaltItemCount,
                                              .unknown_model = Code::kBasaltUnknownModel,
                                              .unknown_parameter = Code::kBasaltUnknownParameter,
                                              .no_size = Code::kBasaltNoSize,
                                              .offset_not_whole = Code::kBasaltOffsetNotWhole,
                                              .offset_invalid = Code::kBasaltOffsetInvalid,
                                              .initial_value = Code::kBasaltInitialValue,
                                              .one_offset = Code::kBasaltOneOffset,
                                              .offset_rounded = Code::kBasaltOffsetRounded,
                                              .further_imu = Code::kBasaltImuDropped}};

/// A limit that was set for another lens is kept where the new one has such a key, and goes where it has none.
void list_stale_radius(const Rig& old, const Rig& rig, std::vector<Loss>& losses) {
  const std::string limit(kMaxRadius);
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    if (camera.model == old.cameras[i].model || old.find_extra_field(camera.name, limit) == nullptr) continue;
    const bool kept = model_info(camera.model).id == "rational";
    losses.push_back(kept ? lost(Code::kBasaltStaleRadius, camera.name, limit)
                          : lost(Code::kNotCarried, camera.name, limit, {Message{Code::kBasaltNoRadiusLimit, {camera.name}}}));
  }
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  return schema::read(kSchema, documents, options, diagnostics);
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> old = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const bool edits = old && !options.rewrite && schema::same_cameras(*old, rig);
  if (edits ? !can_store(kFormat, rig, &*old, diagnostics)
            : !writable_alone(kFormat, rig, Message{Code::kBasaltDemandsSize}, diagnostics))
    return std::nullopt;
  if (!have_positive_determinants(rig, kPoseInImu, Code::kBasaltMirror, diagnostics)) return std::nullopt;

  Written written;
  if (edits) list_stale_radius(*old, rig, written.losses);
  std::optional<text::Document> document =
      edits ? schema::edited(*base, {kSchema, *old}, {kSchema, rig}, written)
            : text::parse_document({"calibration.json", schema::composed_json(kSchema, rig, 0, written)}, diagnostics);
  if (!document) return std::nullopt;
  written.files.push_back({*std::move(document), {}, {"basalt"}});
  for (const Camera& camera : rig.cameras) written.files.front().cameras.push_back(camera.name);
  const std::vector<ExtraField> said = edits ? old->extra_fields : schema::carried(kSchema, rig);
  const Message no_place{Code::kBasaltNoPlace};
  add_extras_lost(rig, said, edits ? std::nullopt : old, no_place, written.losses);
  schema::list_losses(kSchema, rig, no_place, written.losses);
  written.headline = {Code::kBasaltWrote};
  return written;
}

ProbeResult probe(const text::Document& document) {
  const Node* value = text::find(document.root(), "value0", kSchema.dialect);
  if (value == nullptr || !value->is_mapping()) return {};
  const auto found = [value](std::string_view key) { return text::find(*value, key, kSchema.dialect) != nullptr; };
  for (const std::string_view key : {"intrinsics", "T_imu_cam"}) {
    if (found(key)) return {evidence::kCamera, Message{Code::kBasaltFound, {key}}};
  }
  const auto* const hint = std::ranges::find_if(kWrittenOrder, found);
  return hint == kWrittenOrder.end() ? ProbeResult() : ProbeResult{evidence::kHint, Message{Code::kBasaltFound, {*hint}}};
}

constexpr std::array kModels = {
    StoredModel{"kb4", "kb4", true, "Basalt", {}},
    StoredModel{"ds", "ds", true, "Basalt", {}},
    StoredModel{"eucm", "eucm", true, "Basalt", {}},
    StoredModel{"ucm", "ucm", true, "Basalt", {}},
    StoredModel{"fov", "fov", true, "Basalt", {}},
    StoredModel{"pinhole", "pinhole", true, "Basalt", {}},
    StoredModel{.model = "rational",
                .file_name = "pinhole-radtan8",
                .read_by = "Basalt since 2022, Monado",
                .ranges = {},
                .since = "2022"},
};

constexpr std::array<std::string_view, 1> kOfTheImages = {kVignette};
constexpr std::array kOwnFacts = {OwnFact{"IMU biases and scale, vignette"}};
constexpr std::array kDemands = {Demand{"pose in the IMU", "T_imu_cam"},
                                 Demand{"IMU noise", "_std", nullptr, &Format::needs_imu},
                                 Demand{"IMU rate", "imu_update_rate", nullptr, &Format::needs_imu}};

}  // namespace

const Format kFormat = {
    .id = "basalt",
    .title = "Basalt calibration",
    .syntaxes = "JSON",
    .extension = ".json",
    .program = "Basalt",
    .many_cameras = true,
    .extrinsics = true,
    .imu = true,
    .needs_imu = true,
    .image_size = true,
    .time_offset = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .of_the_images = kOfTheImages,
    .models = kModels,
    .table = &kSchema,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::basalt
