// SPDX-License-Identifier: BSD-3-Clause
// An existing file is written into: what the input says takes the place of what it said.
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/format.h>
#include <fca/rig/rig.h>

#include <string>
#include <vector>

namespace fca {

/// What of a base stays that the input says nothing of, and what does not.
struct Kept {
  std::vector<std::string> names;     ///< Of the rig's cameras, in its order, as the base or the result calls them.
  std::vector<std::string> replaced;  ///< Its cameras whose place another one of the input takes.
  std::vector<std::string> cameras;
  std::vector<PoseEdge> poses;            ///< Of cameras that are now others.
  std::optional<double> baseline_m = {};  ///< Of a rectified pair or depth sensor that is now another.
};

/// What `base` is to say: the rig's cameras in the place of the base's of the same names or, where no name is known there or
/// `in_order` is asked for, one after the other, and then under the base's names, with a note; of IMUs, poses, times, rates and
/// topics what the rig states, else what the base states. Cameras that only the base has stay.
[[nodiscard]] Rig put_into(const Rig& base, Rig rig, bool in_order, Kept& kept, Diagnostics& diagnostics);

/// A note on what was kept, of that which the files written still hold (a mode may have no place for it).
void tell_of_kept(const Kept& kept, const Written& written, Diagnostics& diagnostics);

/// Does the rig say one of the poses that `base` holds, of two cameras or frames, under its own names of them or, in order,
/// under others?
[[nodiscard]] bool says_a_pose_of(const Rig& base, const Rig& rig);

}  // namespace fca
