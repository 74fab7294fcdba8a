// SPDX-License-Identifier: BSD-3-Clause
// What a settings file for a rig says, key by key, and how a fresh file is spelled.
#pragma once

#include "layout.h"
#include "tuning.h"

#include "../fields.h"

#include <fca/formats/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::orbslam3 {

/// Of upstream's examples, in Hz: where nobody specifies one.
inline constexpr double kUpstreamFrameRate = 20.0;

/// ORB-SLAM3's sensor modes.
struct Sensor {
  std::string_view id;  ///< As WriteOptions::sensor says it.
  bool two_cameras = false;
  bool depth = false;
  bool inertial = false;
};

/// From the poorest to the richest; a rig is written for the last that it fully serves (depth only when asked).
inline constexpr std::array kSensors = {
    Sensor{"mono", false, false, false},        Sensor{"rgbd", false, true, false},
    Sensor{"rgbd-inertial", false, true, true}, Sensor{"mono-inertial", false, false, true},
    Sensor{"stereo", true, false, false},       Sensor{"stereo-inertial", true, false, true},
};
[[nodiscard]] const Sensor* find_sensor(std::string_view id);

/// What one settings file is to be.
struct Target {
  Style style = Style::kV1;
  Sensor sensor;
  double frame_rate_hz = 0.0;
  bool frame_rate_known = false;
  Tuning tuning = {};
  std::optional<double> max_angle_rad = {};  ///< What counts as lens, from the axis.
  bool states_delay = false;                 ///< The base specifies the first camera's time offset, under kDelayKey.
  std::string_view imu_pose_key =
      {};  ///< Under which the base specifies the first camera's pose, also where no mode asks for it.
  bool states_rectification = false;  ///< ORB-SLAM2's LEFT.* and RIGHT.*, of Rig::rectified.
};

/// Two cameras of one pair whose images are already rectified: one set of intrinsics without distortion, and a baseline.
[[nodiscard]] bool is_rectified_pair(const Rig& rig);

/// All fields of the file, in the order of upstream's examples. Precondition: missing_for() found
/// nothing, and the style can store the models.
[[nodiscard]] std::vector<fields::Field> settings_fields(const Rig& rig, const Target& target);

/// Does the program stop in a mode with depth and an IMU? ORB-SLAM3 asks for a second KannalaBrandt8 camera there
/// (Tracking.cc), which no such file holds.
[[nodiscard]] bool crashes_with_depth_and_imu(const Rig& rig, Style style);

/// What the rig lacks for a sensor mode, as clauses; empty: it serves.
[[nodiscard]] std::vector<Message> missing_for(const Rig& rig, const Sensor& sensor, Style style);

/// Clauses as those of one argument: "a, b and c".
[[nodiscard]] std::vector<Message> enumerated(std::vector<Message> clauses);

/// Which of the fields hold a value that no input specifies.
[[nodiscard]] std::vector<DefaultedValue> defaulted(const std::vector<fields::Field>& fields, const Target& target,
                                                    const Rig& rig);

/// A fresh file: `headline` as its first comment, the fields under headings, a comment at every value that no input specifies.
[[nodiscard]] std::optional<text::Document> compose(const std::vector<fields::Field>& fields, const Target& target,
                                                    const Rig& rig, std::string_view headline, Diagnostics& diagnostics);

}  // namespace fca::orbslam3
