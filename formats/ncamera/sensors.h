// SPDX-License-Identifier: BSD-3-Clause
// maplab's list of sensors: cameras and IMU stand among others, and their poses to each other below the list.
#pragma once

#include <fca/formats/format.h>

namespace fca::ncamera {

/// Where a list of sensors has the parts of a calibration; null: nowhere.
struct Sensors {
  const text::Node* cameras = nullptr;  ///< The first NCAMERA.
  const text::Node* imu = nullptr;      ///< The first IMU.
  std::vector<const text::Node*> others = {};
};

/// Nothing of a document of another layout.
[[nodiscard]] std::optional<Sensors> find_sensors(const text::Document& document);

[[nodiscard]] std::optional<Rig> read_sensors(const text::Document& document, const Sensors& sensors,
                                              const ReadOptions& options, Diagnostics& diagnostics);

/// The base with what `rig` says of cameras and IMU; `old` is what it says.
[[nodiscard]] text::Document edited_sensors(const text::Document& base, const Sensors& sensors, const Rig& old, const Rig& rig,
                                            Written& written);

}  // namespace fca::ncamera
