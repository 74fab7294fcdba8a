// SPDX-License-Identifier: BSD-3-Clause
// Poses that contradict each other: how gravely, and which of them is wrong. It is decided here, for whoever reports it.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/pose_loops.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace fca {

/// Why a pose is the wrong one.
enum class Blame {
  kNone,           ///< Nothing tells which it is.
  kOthersAgree,    ///< Without it all others agree, and without no other one.
  kOrderOfPair,    ///< Of those without which all agree, it alone puts the second camera of a stereo pair on the left.
  kCommonMistake,  ///< Undoing that makes it agree with the others.
};

struct Contradiction {
  PoseLoop loop;               ///< Its edge is the wrong pose, or without blame the last of the loop that was read.
  Blame blame = Blame::kNone;  ///< Of that edge.
  Code mistake = {};           ///< Of pose_mistakes(), if it explains that edge; kPoseHoldsInverse: inverting it resolves it.
  Severity severity = Severity::kWarning;  ///< An error above 0.5 deg or 1 cm, and of a mistake.
  /// Without blame: in Rig::poses, those of which a mistake would explain it.
  std::vector<std::size_t> candidates = {};
};

/// In the order of their edges: all that one wrong pose contradicts is one. Where a pose is no rotation, none is blamed.
[[nodiscard]] std::vector<Contradiction> contradictions(const Rig& rig);

/// The contradiction of a rig that is resolved by leaving out its edge: by two against one, or by the order of the pair.
/// Nothing where there is none, several, or nothing but a mistake tells which pose is wrong.
[[nodiscard]] std::optional<Contradiction> outvoted_pose(const Rig& rig);

/// Is it a code by which one is reported: an id of contradicting poses, or a common mistake?
[[nodiscard]] bool reports_contradiction(Code code);

/// Is a translation from that frame too long for metres? Cars are longer than 5 m, but their cameras and IMUs sit closer
/// together; a vehicle's frame may be at its other end.
[[nodiscard]] bool is_too_long(double metres, std::string_view from, const Rig& rig);

/// The rig without one of its poses, by its place in Rig::poses.
[[nodiscard]] Rig without_pose(std::size_t edge, Rig rig);

}  // namespace fca
