// SPDX-License-Identifier: BSD-3-Clause
// --into BASE: an existing file with what the input says in the place of what it said.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

namespace fca::cli {

/// What `base` is to say: the rig's cameras in the place of the base's of the same names or, where no name is known there or
/// `in_order` is asked for, one after the other, and then under the base's names, with a note; of IMUs, poses, times, rates and
/// topics what the rig states, else what the base states. Cameras that only the base has stay, with a note.
[[nodiscard]] Rig put_into(const Rig& base, Rig rig, bool in_order, Diagnostics& diagnostics);

/// Does the rig say one of the poses that `base` holds, of two cameras or frames, under its own names of them or, in order,
/// under others?
[[nodiscard]] bool says_a_pose_of(const Rig& base, const Rig& rig);

}  // namespace fca::cli
