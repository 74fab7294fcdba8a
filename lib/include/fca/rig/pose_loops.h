// SPDX-License-Identifier: BSD-3-Clause
// Poses that are specified and follow from others, too: by which paths, and how far the two are apart.
#pragma once

#include <fca/rig/rig.h>

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

namespace fca {

/// How far two statements of one pose are apart.
struct PoseDifference {
  double angle_rad = 0.0;
  double distance_m = 0.0;
  double largest_element = 0.0;  ///< Of the difference of the two matrices.
  /// By more than a millimetre or a twentieth of a degree; programs print both from one estimate, to 1e-15.
  [[nodiscard]] bool contradicts() const;
};
[[nodiscard]] PoseDifference difference_of(const Transform& a, const Transform& b);

/// A loop in the graph of the poses: two paths between the same two frames.
struct PoseLoop {
  std::size_t edge = 0;           ///< In Rig::poses: of pose_loops() the last of the loop that was read.
  std::vector<std::size_t> path;  ///< The other edges, from its a to its b: the shortest path.
  Transform around;               ///< T_a_b of that edge as the path says it.
  PoseDifference difference;      ///< Between the two statements.
};

/// The independent loops, in the order in which their last edges were read, with the shortest path of those that were read
/// before: every other loop is made of these. Poses that cannot be inverted where that is needed close none.
[[nodiscard]] std::vector<PoseLoop> pose_loops(const Rig& rig);

/// Those whose two paths differ.
[[nodiscard]] std::vector<PoseLoop> contradicting_loops(const Rig& rig);

/// The loop of one pose, by its place in Rig::poses, with the shortest path of all others; nothing if there is none.
[[nodiscard]] std::optional<PoseLoop> pose_loop(std::size_t edge, const Rig& rig);

/// The places in Rig::poses of all poses of the loops.
[[nodiscard]] std::set<std::size_t> edges_of(const std::vector<PoseLoop>& loops);

}  // namespace fca
