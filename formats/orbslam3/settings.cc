// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include "columns.h"
#include "left_right.h"

#include <fca/code.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace fca::orbslam3 {

namespace {

using fields::Field;

const Transform* stated_or(const Rig& rig, std::string_view a, std::string_view b, std::optional<Transform>& storage) {
  if (const Transform* T = rig.stated(a, b)) return T;
  storage = rig.resolve(a, b);
  return storage ? &*storage : nullptr;
}

double baseline(const Rig& rig, const Sensor& sensor) {
  if (sensor.depth || rig.cameras.size() < 2) return rig.baseline_m.value_or(0.0);
  const std::optional<Transform> T = rig.resolve(rig.cameras[0].name, rig.cameras[1].name);
  return T ? distance_of(*T) : 0.0;
}

/// The numbers without a lens, as every layout begins.
constexpr std::size_t kFocalAndCentre = 4;

void add_camera(const Camera& camera, const Layout& layout, std::string_view prefix, bool with_lens,
                std::vector<Field>& fields) {
  for (const Slot& slot : std::span(layout.slots).first(with_lens ? layout.slots.size() : kFocalAndCentre)) {
    const double value = slot.parameter ? parameter(camera.model, *slot.parameter).value() : 0.0;
    // k3 of a file with four coefficients: never said, never written.
    if (!slot.required && slot.parameter && value == 0.0 && slot.key == "k3") continue;
    fields.push_back(fields::real(std::string(prefix) + std::string(slot.key), value));
  }
}

/// slam_no_opt's RIGHT.K, RIGHT.D, CAMERA.R, CAMERA.T (p_right = R p_left + T), and LEFT.* next to them.
void add_right_camera(const Rig& rig, const Layout& layout, std::vector<Field>& fields) {
  const auto add_side = [&](std::string_view side, const Camera& camera) {
    const auto value = [&camera](ParameterId id) { return parameter(camera.model, id).value(); };
    if (camera.image_size) {
      fields.push_back(fields::integer(std::string(side) + ".height", camera.image_size->height));
      fields.push_back(fields::integer(std::string(side) + ".width", camera.image_size->width));
    }
    std::vector<double> d;
    for (const Slot& slot : std::span(layout.slots).subspan(kFocalAndCentre))
      d.push_back(slot.parameter ? value(*slot.parameter) : 0.0);
    d.push_back(0.0);
    const std::array<double, 9> k = {value("fx"), 0.0, value("cx"), 0.0, value("fy"), value("cy"), 0.0, 0.0, 1.0};
    fields.push_back(fields::matrix(std::string(side) + ".D", d, static_cast<int>(d.size()), "d"));
    fields.push_back(fields::matrix(std::string(side) + ".K", k, 3, "d"));
  };
  add_side("LEFT", rig.cameras[0]);
  add_side("RIGHT", rig.cameras[1]);
  std::optional<Transform> storage;
  const Transform& T = *stated_or(rig, rig.cameras[1].name, rig.cameras[0].name, storage);
  fields.push_back(fields::matrix(
      "CAMERA.R", std::array{T(0, 0), T(0, 1), T(0, 2), T(1, 0), T(1, 1), T(1, 2), T(2, 0), T(2, 1), T(2, 2)}, 3, "d"));
  fields.push_back(fields::matrix("CAMERA.T", std::array{T(0, 3), T(1, 3), T(2, 3)}, 3, "d"));
}

void add_stereo(const Rig& rig, const Target& target, std::vector<Field>& fields) {
  if (!target.sensor.two_cameras || rig.cameras.size() < 2) return;
  const Camera& second = rig.cameras[1];
  const Layout& layout = *find_layout(target.style, model_info(second.model).id);
  if (target.style == Style::kSlamNoOpt) {
    add_right_camera(rig, layout, fields);
    return;
  }
  add_camera(second, layout, camera_prefix(target.style, 1), true, fields);
  std::optional<Transform> storage;
  const Transform& T = *stated_or(rig, rig.cameras[0].name, second.name, storage);
  const bool v1 = target.style == Style::kV1;
  // Tlr is read as 3 x 4 (Tracking.cc), T_c1_c2 as 4 x 4.
  fields.push_back(
      fields::matrix(std::string(pose_keys(target.style).T_c1_c2), std::span(T.values).first(v1 ? 16 : 12), 4, "f"));
  for (const OverlapColumn& column : overlap_columns(rig, target))
    fields.push_back(target.tuning.field(*column.key, target.style, column.computed));
}

/// By which ORB-SLAM2 rectifies the images.
void add_rectification(const Rig& rig, const Target& target, std::vector<Field>& fields) {
  if (!target.states_rectification || !target.sensor.two_cameras || !rig.rectified || rig.rectified->sources.size() != 2)
    return;
  const std::vector<Field> added = left_right_fields(*rig.rectified);
  fields.insert(fields.end(), added.begin(), added.end());
}

void add_image(const Rig& rig, const Target& target, std::vector<Field>& fields) {
  if (const std::optional<ImageSize>& size = rig.cameras[0].image_size) {
    fields.push_back(fields::integer("Camera.width", size->width));
    fields.push_back(fields::integer("Camera.height", size->height));
  }
  const auto whole_rate = static_cast<int>(std::lround(target.frame_rate_hz));
  fields.push_back(target.style == Style::kV1 ? fields::integer("Camera.fps", whole_rate)
                                              : fields::real("Camera.fps", target.frame_rate_hz));
  fields.push_back(target.tuning.field(tuning_key::kColourOrder, target.style));
}

void add_depth(const Rig& rig, const Target& target, std::vector<Field>& fields) {
  if (!target.sensor.two_cameras && !target.sensor.depth) return;
  const bool v1 = target.style == Style::kV1;
  const bool states_baseline = target.sensor.depth || is_rectified_pair(rig);
  if (v1 && states_baseline) fields.push_back(fields::real("Stereo.b", baseline(rig, target.sensor)));
  if (!v1) {
    fields.push_back(fields::real("Camera.bf", baseline(rig, target.sensor) * parameter(rig.cameras[0].model, "fx").value()));
  }
  fields.push_back(target.tuning.field(tuning_key::kThDepth, target.style));
  if (target.sensor.depth) fields.push_back(target.tuning.field(tuning_key::kDepthMapFactor, target.style));
}

void add_delay(const Rig& rig, const Target& target, std::vector<Field>& fields) {
  const std::optional<double>& offset = rig.cameras.front().time_offset_s;
  if (target.states_delay && offset) fields.push_back(fields::real(std::string(kDelayKey), 0.0 - *offset));
}

void add_imu(const Rig& rig, const Target& target, std::vector<Field>& fields) {
  const bool pose_always = target.style == Style::kSlamNoOpt;  // it reads Camera.Tbc without asking whether it is there
  if (!target.sensor.inertial && !pose_always && target.imu_pose_key.empty()) return;
  std::optional<Transform> storage;
  const Transform* T = stated_or(rig, "imu0", rig.cameras[0].name, storage);
  const Transform identity;
  if (T == nullptr && pose_always) T = &identity;
  const std::string_view key = target.imu_pose_key.empty() ? pose_keys(target.style).T_imu_c1 : target.imu_pose_key;
  if (T != nullptr) fields.push_back(fields::matrix(std::string(key), T->values, 4, "f"));
  if (!target.sensor.inertial) return;
  const Imu& imu = rig.imus.front();
  fields.push_back(fields::real("IMU.NoiseGyro", *imu.gyroscope_noise_density));
  fields.push_back(fields::real("IMU.NoiseAcc", *imu.accelerometer_noise_density));
  fields.push_back(fields::real("IMU.GyroWalk", *imu.gyroscope_random_walk));
  fields.push_back(fields::real("IMU.AccWalk", *imu.accelerometer_random_walk));
  // V1.0 demands a real here, the parser before it an int.
  fields.push_back(target.style == Style::kV1 ? fields::real("IMU.Frequency", *imu.rate_hz)
                                              : fields::integer("IMU.Frequency", static_cast<int>(std::lround(*imu.rate_hz))));
  if (target.tuning.states(tuning_key::kInsertKeyFrames))
    fields.push_back(target.tuning.field(tuning_key::kInsertKeyFrames, target.style));
}

void add_program_tuning(const Target& target, std::vector<Field>& fields) {
  for (const TuningKey& key : program_tuning()) {
    if (!key.optional || target.tuning.states(key)) fields.push_back(target.tuning.field(key, target.style));
  }
}

/// Has the camera no lens to speak of, as those of rectified images?
bool is_straight(const CameraModel& model) {
  if (model_info(model).id == "pinhole") return true;
  const std::span<const double> lens = parameter_values(model).subspan(kFocalAndCentre);
  return model_info(model).id == "radtan" && std::ranges::all_of(lens, [](double value) { return value == 0.0; });
}

/// What one camera lacks to stand for a pair.
Message missing_for_pair(const Rig& rig) {
  const Camera& camera = rig.cameras.front();
  if (is_straight(camera.model)) return {Code::kOrbslam3LacksSecondOrBaseline};
  if (!rig.baseline_m) return {Code::kOrbslam3LacksSecond};
  return {Code::kOrbslam3LacksSecondRectified, {camera.name, model_info(camera.model).id}};
}

}  // namespace

bool is_rectified_pair(const Rig& rig) {
  return rig.cameras.size() == 1 && rig.baseline_m && is_straight(rig.cameras.front().model);
}

const Sensor* find_sensor(std::string_view id) {
  const auto* const found = std::ranges::find(kSensors, id, &Sensor::id);
  return found == kSensors.end() ? nullptr : found;
}

bool crashes_with_depth_and_imu(const Rig& rig, Style style) {
  return (style == Style::kV1 || style == Style::kOld) && model_info(rig.cameras.front().model).id == "kb4";
}

std::vector<Message> missing_for(const Rig& rig, const Sensor& sensor, Style style) {
  std::vector<Message> missing;
  const auto lacks = [&missing](Code code, std::vector<Argument> arguments = {}) {
    missing.push_back({code, std::move(arguments)});
  };
  const Camera& first = rig.cameras.front();
  const bool second = rig.cameras.size() > 1;
  if (sensor.two_cameras && !second && !is_rectified_pair(rig)) missing.push_back(missing_for_pair(rig));
  if (sensor.two_cameras && second && !rig.resolve(first.name, rig.cameras[1].name))
    lacks(Code::kOrbslam3LacksPose, {rig.cameras[1].name, first.name});
  if (second && rig.cameras[0].image_size != rig.cameras[1].image_size && sensor.two_cameras)
    lacks(Code::kOrbslam3LacksOneSize);
  if (sensor.depth && !rig.baseline_m) {
    missing.push_back(second ? Message{Code::kOrbslam3LacksBaselineOfOne, {first.name}}
                             : Message{Code::kOrbslam3LacksBaseline});
  }
  if (!sensor.inertial) return missing;
  if (sensor.depth && crashes_with_depth_and_imu(rig, style)) lacks(Code::kOrbslam3LacksLensForDepth);
  if (style == Style::kSlamNoOpt || style == Style::kOrbSlam2) {
    lacks(Code::kOrbslam3LacksInertialMode, {style == Style::kSlamNoOpt ? "slam_no_opt" : "ORB-SLAM2"});
    return missing;
  }
  if (!rig.resolve("imu0", first.name)) lacks(Code::kOrbslam3LacksImuPose, {first.name});
  const Imu imu = rig.imus.empty() ? Imu{} : rig.imus.front();
  const bool noise = imu.gyroscope_noise_density && imu.accelerometer_noise_density && imu.gyroscope_random_walk &&
                     imu.accelerometer_random_walk;
  if (rig.imus.empty()) {
    lacks(Code::kOrbslam3LacksImu);
    return missing;
  }
  if (!noise) lacks(Code::kOrbslam3LacksImuNoise);
  if (!imu.rate_hz) lacks(Code::kOrbslam3LacksImuRate);
  return missing;
}

std::vector<Message> enumerated(std::vector<Message> clauses) {
  for (std::size_t i = 1; i < clauses.size(); ++i) {
    const Code joint = i + 1 == clauses.size() ? Code::kOrbslam3AndLast : Code::kOrbslam3Further;
    clauses[i] = Message{joint, {std::move(clauses[i])}};
  }
  return clauses;
}

std::vector<Field> settings_fields(const Rig& rig, const Target& target) {
  const Camera& first = rig.cameras.front();
  const Layout& layout = *find_layout(target.style, model_info(first.model).id);
  const bool as_rectified = target.style == Style::kV1 && target.sensor.two_cameras && is_rectified_pair(rig);
  std::vector<Field> fields;
  if (target.style == Style::kV1) fields.push_back(fields::quoted("File.version", "1.0"));
  if (!layout.type.empty()) fields.push_back(fields::quoted("Camera.type", as_rectified ? "Rectified" : layout.type));
  add_camera(first, layout, camera_prefix(target.style, 0), !as_rectified, fields);
  add_stereo(rig, target, fields);
  add_image(rig, target, fields);
  add_depth(rig, target, fields);
  add_delay(rig, target, fields);
  add_rectification(rig, target, fields);
  add_imu(rig, target, fields);
  add_program_tuning(target, fields);
  return fields;
}

}  // namespace fca::orbslam3
