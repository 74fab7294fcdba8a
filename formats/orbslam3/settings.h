// SPDX-License-Identifier: BSD-3-Clause
// What a settings file for a rig says, key by key, and how a fresh file is spelled.
#pragma once

#include "layout.h"

#include "../fields.h"

#include <fca/formats/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::orbslam3 {

/// ORB-SLAM3's sensor modes.
struct Sensor {
  std::string_view id;
  bool two_cameras = false;
  bool depth = false;
  bool inertial = false;
};

/// From the poorest to the richest; a rig is written for the last that it fully serves (depth only when asked).
[[nodiscard]] std::span<const Sensor> sensors();
[[nodiscard]] const Sensor* find_sensor(std::string_view id);

/// What a file states beyond the rig and a change of style or sensor must keep; nothing where it does not, then upstream's
/// example values are written.
struct Tuning {
  std::optional<int> colour_order;         ///< Camera.RGB: 1 is RGB
  std::optional<double> th_depth;          ///< close/far threshold in baselines
  std::optional<double> depth_map_factor;  ///< depth image units per metre
};
[[nodiscard]] Tuning tuning_of(const text::Document& document);

/// What one settings file is to be.
struct Target {
  Style style = Style::kV1;
  Sensor sensor;
  double frame_rate_hz = 0.0;
  bool frame_rate_known = false;
  Tuning tuning = {};
};

/// The fields of the camera, stereo and IMU parts, in the order of upstream's examples. Precondition: missing_for() found
/// nothing, and the style can store the models.
[[nodiscard]] std::vector<fields::Field> settings_fields(const Rig& rig, const Target& target);

/// What the rig lacks for a sensor mode, in words with the option that would give it; empty: it serves.
[[nodiscard]] std::vector<std::string> missing_for(const Rig& rig, const Sensor& sensor, Style style);

/// Which of the fields hold upstream's example value because no input states them.
[[nodiscard]] std::vector<DefaultedValue> defaulted(const std::vector<fields::Field>& fields, const Target& target,
                                                    const Rig& rig);

/// A complete file: `headline` as a comment, the fields under headings, then ORBextractor and Viewer with upstream's values.
[[nodiscard]] std::string compose(const std::vector<fields::Field>& fields, const Target& target, const Rig& rig,
                                  std::string_view headline);

}  // namespace fca::orbslam3
