// SPDX-License-Identifier: BSD-3-Clause
// Where cameras, IMUs and further frames sit to each other: the rig from above and from the side, to scale.
#pragma once

#include "html.h"

#include <fca/rig/rig.h>

#include <string>
#include <vector>

namespace fca::cli {

/// Frames whose place in the frame of the rig's first camera (or, without cameras, of the first frame that a pose names) is
/// known, and those of which nothing says it.
struct PlacedRig {
  struct Frame {
    std::string name;
    Transform T_first_frame;
    enum class Kind { kCamera, kImu, kOther } kind = Kind::kOther;
  };
  std::vector<Frame> frames;          ///< The first one first.
  std::vector<std::string> unplaced;  ///< Names.
};
[[nodiscard]] PlacedRig placed_rig(const Rig& rig);

/// Two figures. `in_metres`: does the file say the unit of positions, or its format?
void put_rig(Html& html, const PlacedRig& placed, bool in_metres);

}  // namespace fca::cli
