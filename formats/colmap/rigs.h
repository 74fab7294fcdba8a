// SPDX-License-Identifier: BSD-3-Clause
// rigs.txt and rigs.bin of a model's folder (colmap@5d968cf, scene/reconstruction_io_text.cc): a line for each rig,
//   RIG_ID NUM_SENSORS TYPE ID (TYPE ID HAS_POSE [QW QX QY QZ TX TY TZ])*
// of which the first sensor is the one that poses are counted from, and a pose is T_sensor_rig in metres. COLMAP before 3.12
// does not read them.
#pragma once

#include "ids.h"

#include <fca/diagnostics.h>
#include <fca/formats/format.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca::colmap {

/// Do its lines hold rigs?
[[nodiscard]] bool is_rigs(const text::Document& document);
[[nodiscard]] ProbeResult probe_rigs(const text::Document& document);

/// Its poses, between sensors as the file calls them: "CAMERA 2".
[[nodiscard]] std::optional<Rig> read_rigs(const text::Document& document, Diagnostics& diagnostics);
/// Calls the sensors in a rig's poses as the cameras with those ids (Format::complete). Without cameras camera 1 is "cam0".
void name_sensors(Rig& rig);

/// The base with the rig's poses of its sensors, where they are others. Nothing is added to it.
[[nodiscard]] text::Document edited_rigs(const text::Document& base, const Rig& rig);

/// The words of a fresh file: all cameras, each of which with known poses to others is in a rig with them. Empty where no pose
/// between cameras is known.
[[nodiscard]] std::vector<std::vector<std::string>> rig_lines(const Rig& rig, std::span<const Id> ids);

}  // namespace fca::colmap
