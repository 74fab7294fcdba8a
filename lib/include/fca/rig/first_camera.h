// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rig/rig.h>

#include <vector>

namespace fca {

/// The rig's poses as its first camera sees them: T_other_first of the other cameras, T_first_frame of all else. What does not
/// hang together with the first camera stays as it is. The rig has a camera.
[[nodiscard]] std::vector<PoseEdge> poses_of_first(const Rig& rig);

}  // namespace fca
