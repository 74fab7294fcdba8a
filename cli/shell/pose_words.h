// SPDX-License-Identifier: BSD-3-Clause
// Poses as sentences.
#pragma once

#include <fca/rig/rig.h>

#include <string>

namespace fca::cli {

/// Where a thing is in a frame, and which way it looks if it is a camera: of a camera's frame in its own words ("10.11 cm to
/// the right, 0.19 cm below"), of any other by its axes ("4.56 cm towards +x"). `T_frame_thing` takes points in the thing to
/// points in the frame.
struct Placement {
  std::string thing;
  std::string frame;
  bool thing_is_camera = false;
  bool frame_is_camera = false;
  Transform T_frame_thing;
};

/// "cam1 sits 10.11 cm to the right of cam0, 0.19 cm below and 0.10 cm ahead, and looks the same way (2.69 deg off)"
[[nodiscard]] std::string placement_in_words(const Placement& placement);

/// The same of a pose as a file specifies it; a camera is placed in what is none, whichever way the file has it. Empty where
/// its 3 x 3 part has no inverse. `in_metres`: does the file say the unit of the position, or its format?
[[nodiscard]] std::string pose_in_words(const PoseEdge& edge, const Rig& rig, bool in_metres = true);

}  // namespace fca::cli
