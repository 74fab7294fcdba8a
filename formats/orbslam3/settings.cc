// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::orbslam3 {

namespace {

using fields::Field;

constexpr std::array kSensors = {
    Sensor{"mono", false, false, false},        Sensor{"rgbd", false, true, false},
    Sensor{"rgbd-inertial", false, true, true}, Sensor{"mono-inertial", false, false, true},
    Sensor{"stereo", true, false, false},       Sensor{"stereo-inertial", true, false, true},
};

/// Upstream's values in Examples/*/*.yaml.
constexpr double kThDepth = 40.0;
constexpr double kDepthMapFactor = 1000.0;
constexpr int kColourOrderRgb = 1;

const Transform* stated_or(const Rig& rig, std::string_view a, std::string_view b, std::optional<Transform>& storage) {
  if (const Transform* T = rig.stated(a, b)) return T;
  storage = rig.resolve(a, b);
  return storage ? &*storage : nullptr;
}

bool rectified(const Rig& rig) {
  return rig.cameras.size() == 1 && rig.baseline_m && model_info(rig.cameras[0].model).id == "pinhole";
}

double baseline(const Rig& rig, const Sensor& sensor) {
  if (sensor.depth || rig.cameras.size() < 2) return rig.baseline_m.value_or(0.0);
  const std::optional<Transform> T = rig.resolve(rig.cameras[0].name, rig.cameras[1].name);
  return T ? std::hypot((*T)(0, 3), (*T)(1, 3), (*T)(2, 3)) : 0.0;
}

void add_camera(const Camera& camera, const Layout& layout, std::string_view prefix, std::vector<Field>& fields) {
  for (const Slot& slot : layout.slots) {
    const double value = slot.parameter.empty() ? 0.0 : parameter(camera.model, slot.parameter).value_or(0.0);
    // k3 of a file with four coefficients: never said, never written.
    if (!slot.required && !slot.parameter.empty() && value == 0.0 && slot.key == "k3") continue;
    fields.push_back(fields::real(std::string(prefix) + std::string(slot.key), value));
  }
}

/// slam_no_opt's RIGHT.K, RIGHT.D, CAMERA.R, CAMERA.T (p_right = R p_left + T), and LEFT.* beside them.
void add_right_camera(const Rig& rig, const Layout& layout, std::vector<Field>& fields) {
  const auto add_side = [&](std::string_view side, const Camera& camera) {
    const auto value = [&camera](std::string_view name) {
      return name.empty() ? 0.0 : parameter(camera.model, name).value_or(0.0);
    };
    if (camera.image_size) {
      fields.push_back(fields::integer(std::string(side) + ".height", camera.image_size->height));
      fields.push_back(fields::integer(std::string(side) + ".width", camera.image_size->width));
    }
    std::vector<double> d;
    for (const Slot& slot : std::span(layout.slots).subspan(4)) d.push_back(value(slot.parameter));
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
  add_camera(second, layout, camera_prefix(target.style, 1), fields);
  std::optional<Transform> storage;
  const Transform& T = *stated_or(rig, rig.cameras[0].name, second.name, storage);
  const bool v1 = target.style == Style::kV1;
  // Tlr is read as 3 x 4 (Tracking.cc), T_c1_c2 as 4 x 4.
  fields.push_back(
      fields::matrix(std::string(pose_keys(target.style).T_c1_c2), std::span(T.values).first(v1 ? 16 : 12), 4, "f"));
  if ((layout.type != "KannalaBrandt8" && layout.type != "DoubleSphere") || !rig.cameras[0].image_size) return;
  const std::string_view first_prefix = camera_prefix(target.style, 0);
  const std::string_view begin = v1 ? "overlappingBegin" : "lappingBegin";
  const std::string_view end = v1 ? "overlappingEnd" : "lappingEnd";
  for (const std::string_view prefix : {first_prefix, camera_prefix(target.style, 1)}) {
    fields.push_back(fields::integer(std::string(prefix) + std::string(begin), 0));
    fields.push_back(fields::integer(std::string(prefix) + std::string(end), rig.cameras[0].image_size->width - 1));
  }
}

void add_image(const Rig& rig, const Target& target, std::vector<Field>& fields) {
  if (const std::optional<ImageSize>& size = rig.cameras[0].image_size) {
    fields.push_back(fields::integer("Camera.width", size->width));
    fields.push_back(fields::integer("Camera.height", size->height));
  }
  const auto whole_rate = static_cast<int>(std::lround(target.frame_rate_hz));
  fields.push_back(target.style == Style::kV1 ? fields::integer("Camera.fps", whole_rate)
                                              : fields::real("Camera.fps", target.frame_rate_hz));
  fields.push_back(fields::integer("Camera.RGB", target.tuning.colour_order.value_or(kColourOrderRgb)));
}

void add_depth(const Rig& rig, const Target& target, std::vector<Field>& fields) {
  if (!target.sensor.two_cameras && !target.sensor.depth) return;
  const bool v1 = target.style == Style::kV1;
  const bool states_baseline = target.sensor.depth || rectified(rig);
  if (v1 && states_baseline) fields.push_back(fields::real("Stereo.b", baseline(rig, target.sensor)));
  if (!v1) {
    fields.push_back(
        fields::real("Camera.bf", baseline(rig, target.sensor) * parameter(rig.cameras[0].model, "fx").value_or(0.0)));
  }
  fields.push_back(fields::real(v1 ? "Stereo.ThDepth" : "ThDepth", target.tuning.th_depth.value_or(kThDepth)));
  if (target.sensor.depth) {
    fields.push_back(
        fields::real(v1 ? "RGBD.DepthMapFactor" : "DepthMapFactor", target.tuning.depth_map_factor.value_or(kDepthMapFactor)));
  }
}

void add_imu(const Rig& rig, const Target& target, std::vector<Field>& fields) {
  const bool pose_always = target.style == Style::kSlamNoOpt;  // it reads Camera.Tbc without asking whether it is there
  if (!target.sensor.inertial && !pose_always) return;
  std::optional<Transform> storage;
  const Transform* T = stated_or(rig, "imu0", rig.cameras[0].name, storage);
  const Transform identity;
  if (T == nullptr) T = &identity;
  fields.push_back(fields::matrix(std::string(pose_keys(target.style).T_imu_c1), T->values, 4, "f"));
  if (!target.sensor.inertial) return;
  const Imu& imu = rig.imus.front();
  fields.push_back(fields::real("IMU.NoiseGyro", *imu.gyroscope_noise_density));
  fields.push_back(fields::real("IMU.NoiseAcc", *imu.accelerometer_noise_density));
  fields.push_back(fields::real("IMU.GyroWalk", *imu.gyroscope_random_walk));
  fields.push_back(fields::real("IMU.AccWalk", *imu.accelerometer_random_walk));
  // V1.0 demands a real here, the parser before it an int.
  fields.push_back(target.style == Style::kV1 ? fields::real("IMU.Frequency", *imu.rate_hz)
                                              : fields::integer("IMU.Frequency", static_cast<int>(std::lround(*imu.rate_hz))));
}

}  // namespace

std::span<const Sensor> sensors() { return kSensors; }

const Sensor* find_sensor(std::string_view id) {
  const auto* const found = std::ranges::find(kSensors, id, &Sensor::id);
  return found == kSensors.end() ? nullptr : found;
}

std::vector<std::string> missing_for(const Rig& rig, const Sensor& sensor, Style style) {
  std::vector<std::string> missing;
  const Camera& first = rig.cameras.front();
  const bool second = rig.cameras.size() > 1;
  if (sensor.two_cameras && !second && !(rectified(rig) && style == Style::kV1)) missing.emplace_back("a second camera");
  if (sensor.two_cameras && second && !rig.resolve(first.name, rig.cameras[1].name)) {
    missing.push_back("the pose of " + rig.cameras[1].name + " to " + first.name);
  }
  if (second && rig.cameras[0].image_size != rig.cameras[1].image_size && sensor.two_cameras)
    missing.emplace_back("one image size for both cameras");
  if (sensor.depth && !rig.baseline_m) missing.emplace_back("the baseline (--baseline METRES)");
  if (!sensor.inertial) return missing;
  if (style == Style::kSlamNoOpt) {
    missing.emplace_back("an inertial mode in slam_no_opt");
    return missing;
  }
  if (!rig.resolve("imu0", first.name)) missing.push_back("the pose of " + first.name + " to the IMU (T_cam_imu)");
  const Imu imu = rig.imus.empty() ? Imu{} : rig.imus.front();
  const bool noise = imu.gyroscope_noise_density && imu.accelerometer_noise_density && imu.gyroscope_random_walk &&
                     imu.accelerometer_random_walk;
  if (!noise) missing.emplace_back("the IMU's noise densities and random walks (--with imu.yaml)");
  if (!imu.rate_hz) missing.emplace_back("the IMU's rate (update_rate in imu.yaml)");
  return missing;
}

Tuning tuning_of(const text::Document& document) {
  Tuning tuning;
  const auto number = [&document](std::initializer_list<std::string_view> keys) -> std::optional<double> {
    for (const std::string_view key : keys) {
      const text::Node* node = find_key(document, key);
      const std::optional<double> value = node != nullptr && node->is_scalar() ? text::parse_real(node->value) : std::nullopt;
      if (value && std::isfinite(*value)) return value;
    }
    return std::nullopt;
  };
  if (const std::optional<double> order = number({"Camera.RGB"})) tuning.colour_order = *order == 0.0 ? 0 : 1;
  tuning.th_depth = number({"Stereo.ThDepth", "ThDepth"});
  tuning.depth_map_factor = number({"RGBD.DepthMapFactor", "DepthMapFactor"});
  return tuning;
}

std::vector<Field> settings_fields(const Rig& rig, const Target& target) {
  const Camera& first = rig.cameras.front();
  const Layout& layout = *find_layout(target.style, model_info(first.model).id);
  const bool as_rectified = target.style == Style::kV1 && target.sensor.two_cameras && rectified(rig);
  std::vector<Field> fields;
  if (target.style == Style::kV1) fields.push_back(fields::quoted("File.version", "1.0"));
  if (!layout.type.empty()) fields.push_back(fields::quoted("Camera.type", as_rectified ? "Rectified" : layout.type));
  add_camera(first, layout, camera_prefix(target.style, 0), fields);
  add_stereo(rig, target, fields);
  add_image(rig, target, fields);
  add_depth(rig, target, fields);
  add_imu(rig, target, fields);
  return fields;
}

namespace {

/// A key upstream's examples fix by hand, and what to tell people about it.
struct Defaulted {
  std::string_view key;
  std::string_view comment;
  bool look_at_it;
};

constexpr std::array kDefaulted = {
    Defaulted{"Camera.fps", "Frames per second: not in the input, upstream's example value. Set your camera's.", true},
    Defaulted{"Camera.RGB", "Colour order (0: BGR, 1: RGB; no matter for grey images): not in the input.", true},
    Defaulted{"Camera1.overlappingBegin", "Columns that both cameras see: not in the input, the whole width.", false},
    Defaulted{"Camera.lappingBegin", "Columns that both cameras see: not in the input, the whole width.", false},
    Defaulted{"Stereo.ThDepth", "Close/far threshold in baselines: tuning, upstream's value.", false},
    Defaulted{"ThDepth", "Close/far threshold in baselines: tuning, upstream's value.", false},
    Defaulted{"RGBD.DepthMapFactor", "Depth image units per metre: not in the input. Set your sensor's.", true},
    Defaulted{"DepthMapFactor", "Depth image units per metre: not in the input. Set your sensor's.", true},
};

bool applies(const Defaulted& row, const Target& target) {
  if (row.key == "Camera.fps") return !target.frame_rate_known;
  if (row.key == "Camera.RGB") return !target.tuning.colour_order;
  if (row.key.ends_with("ThDepth")) return !target.tuning.th_depth;
  if (row.key.ends_with("DepthMapFactor")) return !target.tuning.depth_map_factor;
  return true;
}

/// Comments that say what a key means.
struct Heading {
  std::string_view key;
  std::string_view comment;
};

constexpr std::array kHeadings = {
    Heading{"Camera2.fx", "Second camera"},
    Heading{"Stereo.T_c1_c2", "Second camera in the first: p_c1 = T p_c2, metres"},
    Heading{"Tlr", "Right camera in the left: p_left = Tlr p_right, metres"},
    Heading{"LEFT.height", "Both cameras again, as slam_no_opt reads them for stereo"},
    Heading{"CAMERA.R", "p_right = R p_left + T, metres"},
    Heading{"Camera.width", "Image"},
    Heading{"Camera.bf", "Baseline times fx"},
    Heading{"Stereo.b", "Baseline, metres"},
    Heading{"IMU.T_b_c1", "First camera in the IMU: p_imu = T p_c1, metres"},
    Heading{"Tbc", "Camera in the IMU: p_imu = Tbc p_camera, metres"},
    Heading{"Camera.Tbc", "Camera in the body or IMU: p_body = Tbc p_camera, metres"},
    Heading{"IMU.NoiseGyro",
            "IMU noise, continuous time: rad/s/sqrt(Hz), m/s^2/sqrt(Hz), rad/s^2/sqrt(Hz), m/s^3/sqrt(Hz); rate in Hz"},
};

/// Keys every mode exits without (Settings.cc, Viewer.cc, ORBextractor), with upstream's values. Reals have a point, ints none.
constexpr std::string_view kTuning = R"(
# ORB extractor: tuning, upstream's values
ORBextractor.nFeatures: 1000
ORBextractor.scaleFactor: 1.2
ORBextractor.nLevels: 8
ORBextractor.iniThFAST: 20
ORBextractor.minThFAST: 7

# Viewer: demanded even without a window, upstream's values
Viewer.KeyFrameSize: 0.05
Viewer.KeyFrameLineWidth: 1.0
Viewer.GraphLineWidth: 0.9
Viewer.PointSize: 2.0
Viewer.CameraSize: 0.08
Viewer.CameraLineWidth: 3.0
Viewer.ViewpointX: 0.0
Viewer.ViewpointY: -0.7
Viewer.ViewpointZ: -3.5
Viewer.ViewpointF: 500.0
)";

}  // namespace

std::vector<DefaultedValue> defaulted(const std::vector<Field>& fields, const Target& target, const Rig& rig) {
  std::vector<DefaultedValue> result;
  for (const Field& field : fields) {
    for (const Defaulted& row : kDefaulted) {
      if (row.key == field.key && applies(row, target)) result.push_back({field.key, field.tokens.front(), row.look_at_it});
    }
    if (field.key == "Camera.Tbc" && !rig.resolve("imu0", rig.cameras.front().name)) {
      result.push_back({"Camera.Tbc", "identity (slam_no_opt does not start without it)", true});
    }
  }
  result.push_back({"ORBextractor.*", "upstream's", false});
  result.push_back({"Viewer.*", "upstream's", false});
  return result;
}

std::string compose(const std::vector<Field>& fields, const Target& target, const Rig& rig, std::string_view headline) {
  std::string text = "%YAML:1.0\n# " + std::string(headline) + "\n\n";
  for (const Field& field : fields) {
    for (const Heading& heading : kHeadings) {
      if (heading.key == field.key) text += "\n# " + std::string(heading.comment) + "\n";
    }
    for (const Defaulted& row : kDefaulted) {
      if (row.key == field.key && applies(row, target)) text += "# Default. " + std::string(row.comment) + "\n";
    }
    if (field.key == "Camera.Tbc" && !rig.resolve("imu0", rig.cameras.front().name))
      text += "# Default. Identity: not in the input.\n";
    text += fields::spell(field) + "\n";
    if (field.key == "Camera.type" || field.key == "File.version") text += "\n";
  }
  text += kTuning;
  return text;
}

}  // namespace fca::orbslam3
