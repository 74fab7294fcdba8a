// SPDX-License-Identifier: BSD-3-Clause
// What two cameras must be like for ORB-SLAM3 to use them as a stereo pair.
#pragma once

#include "settings.h"

#include <fca/diagnostics.h>

namespace fca::orbslam3 {

/// Does the style have a place for the pair? Before V1.0, settings of pinhole cameras hold one set of intrinsics and Camera.bf
/// for both.
[[nodiscard]] bool holds_pair(const Rig& rig, Style style);

/// Are pairs of that model rectified, and their matches looked for along the rows? Fisheyes are matched as they are.
[[nodiscard]] bool matches_along_rows(std::string_view model);

/// False with an error where the style has no place for the pair.
[[nodiscard]] bool check_pair(const Rig& rig, const Target& target, Diagnostics& diagnostics);

/// Warnings of a pair that can be written and that the program will hardly match: nothing seen by both, one camera above the
/// other, images of different moments.
void warn_of_pair(const Rig& rig, const Target& target, Diagnostics& diagnostics);

}  // namespace fca::orbslam3
