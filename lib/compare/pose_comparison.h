// SPDX-License-Identifier: BSD-3-Clause
// Poses of two rigs, and the common mistakes by which one becomes the other.
#pragma once

#include "matching.h"

#include <fca/compare/report.h>
#include <fca/rig/rig.h>

#include <vector>

namespace fca::internal {

/// Two rigs with the other's poses in the reference's names (renamed_poses).
struct PoseTask {
  const Rig& reference;
  const Rig& other;
  const Matching& matching;
  std::vector<PoseEdge> poses;

  PoseTask(const Rig& the_reference, const Rig& the_other, const Matching& the_matching);
};

/// Adds how each camera sits in each further frame, and to its neighbour, where both say it, and names what only one says.
void compare_poses(const PoseTask& task, RigComparison& result);

/// Do the other's poses agree with the reference's if two cameras (indices into the matching) are exchanged, and not as they
/// are?
[[nodiscard]] bool exchange_explains_poses(const PoseTask& task, std::size_t first, std::size_t second);

/// How many of the other's statements does the reference state or imply, too?
[[nodiscard]] std::size_t comparable_poses(const PoseTask& task);

/// Of each statement of the other that the reference contradicts: the mistake that explains it.
[[nodiscard]] std::vector<Mistake> mistaken_poses(const PoseTask& task);

}  // namespace fca::internal
