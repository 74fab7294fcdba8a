// SPDX-License-Identifier: BSD-3-Clause
// Which camera and IMU of one rig is which of the other.
#pragma once

#include <fca/rig/rig.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fca::internal {

/// Indices into the two rigs' lists.
struct Match {
  std::size_t reference = 0;
  std::size_t other = 0;
};

struct Matching {
  std::vector<Match> cameras;
  std::vector<Match> imus;
};

/// By name; by order where no name is common, or always for cameras if `by_order`.
[[nodiscard]] Matching match(const Rig& reference, const Rig& other, bool by_order);

/// The other's poses with the reference's names, in the same order. What has no partner gets a name that nothing else has.
[[nodiscard]] std::vector<PoseEdge> renamed_poses(const Rig& reference, const Rig& other, const Matching& matching);

}  // namespace fca::internal
