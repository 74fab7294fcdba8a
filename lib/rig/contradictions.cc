// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/contradictions.h>

#include <fca/code.h>
#include <fca/rig/pose_mistake.h>
#include <fca/rig/rotation.h>
#include <fca/rig/stereo_order.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <utility>

namespace fca {

namespace {

/// But for the digits that were not printed.
bool is_rotation(const PoseEdge& edge) {
  constexpr double kPrintedWithTwoDigits = 2e-2;
  return rotation_determinant(edge.T_a_b) > 0.0 && rotation_defect(edge.T_a_b) <= kPrintedWithTwoDigits;
}

/// A matrix that mirrors is no pose: what it differs by is no angle.
bool has_mirror(const PoseLoop& loop, const Rig& rig) {
  const auto is_mirror = [&rig](std::size_t edge) { return !(rotation_determinant(rig.poses[edge].T_a_b) > 0.0); };
  return is_mirror(loop.edge) || std::ranges::any_of(loop.path, is_mirror);
}

Severity severity_of(const PoseDifference& difference) {
  constexpr double kSmallAngle = 0.5 * std::numbers::pi / 180.0;
  constexpr double kSmallDistance = 1e-2;  // m
  const bool is_small = difference.angle_rad <= kSmallAngle && difference.distance_m <= kSmallDistance;
  return is_small ? Severity::kWarning : Severity::kError;
}

Contradiction blamed(PoseLoop loop, Blame blame, Code mistake) {
  const Severity severity = mistake == Code::kNone ? severity_of(loop.difference) : info(mistake).severity;
  return {std::move(loop), blame, mistake, severity};
}

/// A pose that contradicts the others.
struct Suspect {
  PoseLoop loop;
  Code mistake = {};         ///< That explains it.
  bool is_outvoted = false;  ///< All others agree.
};

/// Of loops that nothing explains, each.
void add_unexplained(const std::vector<PoseLoop>& loops, const std::vector<Suspect>& candidates,
                     std::vector<Contradiction>& found) {
  std::vector<std::size_t> edges;
  edges.reserve(candidates.size());
  for (const Suspect& each : candidates) edges.push_back(each.loop.edge);
  for (const PoseLoop& loop : loops) found.push_back({loop, Blame::kNone, Code::kNone, severity_of(loop.difference), edges});
}

/// Are the first two cameras a stereo pair in its usual order?
bool is_left_of_second(const Rig& rig) {
  return rig.cameras.size() > 1 && !second_left_of_first(rig) && !second_below_first(rig) &&
         may_be_stereo(rig, rig.cameras[0], rig.cameras[1]);
}

/// Is it a pose of each of the loops? A loop without it contradicts as before.
bool is_in_all(const std::vector<PoseLoop>& loops, std::size_t edge) {
  return std::ranges::all_of(loops, [edge](const PoseLoop& loop) {
    return loop.edge == edge || std::ranges::find(loop.path, edge) != loop.path.end();
  });
}

/// In the order in which they were read.
std::vector<Suspect> suspects_in(const Rig& rig, const std::vector<PoseLoop>& loops) {
  std::vector<Suspect> suspects;
  for (const std::size_t edge : edges_of(loops)) {
    std::optional<PoseLoop> loop = pose_loop(edge, rig);
    if (!loop || !loop->difference.contradicts()) continue;
    const bool is_outvoted = is_in_all(loops, edge) && contradicting_loops(without_pose(edge, rig)).empty();
    suspects.push_back({*loop, mistake_in(rig.poses[edge].T_a_b, loop->around), is_outvoted});
  }
  return suspects;
}

template <class Is>
std::vector<Suspect> those(const std::vector<Suspect>& suspects, const Is& is) {
  std::vector<Suspect> left;
  std::ranges::copy_if(suspects, std::back_inserter(left), is);
  return left;
}

/// Those of several suspects that are `likely`; all where that is none of them.
template <class Likely>
std::vector<Suspect> preferred(const std::vector<Suspect>& suspects, const Likely& likely) {
  if (suspects.size() < 2) return suspects;
  std::vector<Suspect> left = those(suspects, likely);
  return left.empty() ? suspects : left;
}

/// Do the others put the second camera of a stereo pair on the right?
auto is_against_order(const Rig& rig) {
  return [&rig](const Suspect& each) { return is_left_of_second(without_pose(each.loop.edge, rig)); };
}

/// Does the pose itself put the second camera of a pair on the right, and do the others put it on the left? Who takes it for
/// the wrong one exchanges the cameras.
auto is_in_usual_order(const Rig& rig) {
  return [&rig](const Suspect& each) {
    Rig alone = rig;
    alone.poses = {rig.poses[each.loop.edge]};
    return is_left_of_second(alone) && alone.resolve(alone.cameras[0].name, alone.cameras[1].name) &&
           second_left_of_first(without_pose(each.loop.edge, rig)).has_value();
  };
}

bool is_only(const std::vector<Suspect>& suspects, std::size_t edge) {
  return suspects.size() == 1 && suspects.front().loop.edge == edge;
}

/// Why that one of them is the wrong one.
Blame blame_of(std::size_t edge, const std::vector<Suspect>& suspects, const Rig& rig) {
  const std::vector<Suspect> outvoted = those(suspects, &Suspect::is_outvoted);
  if (is_only(outvoted, edge)) return Blame::kOthersAgree;
  return is_only(those(outvoted, is_against_order(rig)), edge) ? Blame::kOrderOfPair : Blame::kCommonMistake;
}

/// Does undoing the mistake leave cameras as far from each other as those of a rig are?
bool leaves_a_rig(const Suspect& suspect) {
  constexpr double kNarrowest = 1e-3;  // m
  constexpr double kWidest = 5.0;
  const double metres = distance_of(suspect.loop.around);
  return metres > kNarrowest && metres < kWidest;
}

/// The one that is wrong, or several of which a mistake would explain it; none where nothing tells.
std::vector<Suspect> accused(const std::vector<Suspect>& suspects, const Rig& rig) {
  const std::vector<Suspect> outvoted = those(suspects, &Suspect::is_outvoted);
  if (outvoted.size() == 1) return outvoted;
  // One wrong pose is a simpler reason than several.
  const std::vector<Suspect> mistaken =
      those(outvoted.empty() ? suspects : outvoted, [](const Suspect& each) { return each.mistake != Code::kNone; });
  if (!mistaken.empty()) {
    const std::vector<Suspect> likely = preferred(preferred(mistaken, leaves_a_rig), is_against_order(rig));
    // The mistake says one thing, and the order of the pair another: nothing tells.
    const bool is_unlikely = likely.size() == 1 && is_in_usual_order(rig)(likely.front());
    return is_unlikely ? std::vector<Suspect>() : likely;
  }
  std::vector<Suspect> by_order = those(outvoted, is_against_order(rig));
  return by_order.size() == 1 ? by_order : std::vector<Suspect>();
}

/// One wrong pose after the other, each with what the others say in its place.
std::vector<Contradiction> one_by_one(Rig rig, std::vector<PoseLoop> loops) {
  std::vector<Contradiction> found;
  const auto is_found = [&found](const Suspect& suspect) {
    return std::ranges::any_of(found, [&](const Contradiction& each) { return each.loop.edge == suspect.loop.edge; });
  };
  while (!loops.empty()) {
    std::vector<Suspect> suspects = suspects_in(rig, loops);
    std::erase_if(suspects, is_found);
    const std::vector<Suspect> wrong = accused(suspects, rig);
    if (wrong.size() != 1) {
      add_unexplained(loops, wrong, found);
      break;
    }
    const PoseLoop& loop = wrong.front().loop;
    found.push_back(blamed(loop, blame_of(loop.edge, suspects, rig), wrong.front().mistake));
    rig.poses[loop.edge].T_a_b = loop.around;
    loops = contradicting_loops(rig);
  }
  std::ranges::stable_sort(found, {}, [](const Contradiction& each) { return each.loop.edge; });
  return found;
}

/// One mistake that was made in all poses of `edges`, where undoing it in all of them closes every loop.
std::vector<Contradiction> made_in_all(const std::vector<std::size_t>& edges, const PoseMistake& mistake, const Rig& rig,
                                       bool (*is_closed)(const PoseLoop&)) {
  Rig meant = rig;
  std::vector<Contradiction> found;
  for (const std::size_t edge : edges) {
    const Transform& stated = rig.poses[edge].T_a_b;
    const std::optional<Transform> undone = mistake.undo(stated);
    if (!undone) return {};
    meant.poses[edge].T_a_b = *undone;
    found.push_back(blamed({edge, {}, *undone, difference_of(stated, *undone)}, Blame::kCommonMistake, mistake.code));
  }
  return std::ranges::all_of(pose_loops(meant), is_closed) ? found : std::vector<Contradiction>();
}

/// Translations of which no other explanation is needed: they are too long for metres, and in a smaller unit all poses agree.
std::vector<Contradiction> in_smaller_unit(const Rig& rig, const std::vector<Suspect>& suspects) {
  std::vector<std::size_t> edges;
  for (std::size_t i = 0; i < rig.poses.size(); ++i) {
    if (is_too_long(distance_of(rig.poses[i].T_a_b), rig.poses[i].a, rig)) edges.push_back(i);
  }
  if (edges.empty() || edges.size() == rig.poses.size()) return {};
  const auto is_closed = [](const PoseLoop& loop) { return !loop.difference.contradicts(); };
  for (const Code unit : {Code::kPoseInMillimetres, Code::kPoseInCentimetres}) {
    const auto mistake = std::ranges::find(pose_mistakes(), unit, &PoseMistake::code);
    std::vector<Contradiction> found = made_in_all(edges, *mistake, rig, is_closed);
    if (found.size() == 1) found.front().blame = blame_of(edges.front(), suspects, rig);
    if (!found.empty()) return found;
  }
  return {};
}

/// The mistake of all poses to an IMU: who writes one the wrong way round writes each of them so. One alone is the simpler
/// reason, but where that exchanges the cameras of a pair.
std::vector<Contradiction> in_all_of_imu(const Rig& rig, const std::vector<Suspect>& suspects) {
  std::vector<std::size_t> edges;
  const auto is_imu = [&rig](const std::string& frame) { return rig.kind_of(frame) == FrameKind::kImu; };
  for (std::size_t i = 0; i < rig.poses.size(); ++i) {
    if (is_imu(rig.poses[i].a) || is_imu(rig.poses[i].b)) edges.push_back(i);
  }
  const auto is_explained = [keeps_order = is_in_usual_order(rig)](const Suspect& suspect) {
    return suspect.mistake != Code::kNone && !keeps_order(suspect);
  };
  if (edges.size() < 2 || std::ranges::any_of(suspects, is_explained)) return {};
  const auto is_closed = [](const PoseLoop& loop) {
    constexpr double kPrinted = 1e-5;  // rad, m
    return loop.difference.angle_rad < kPrinted && loop.difference.distance_m < kPrinted;
  };
  for (const PoseMistake& mistake : pose_mistakes()) {
    std::vector<Contradiction> found = made_in_all(edges, mistake, rig, is_closed);
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace

std::vector<Contradiction> contradictions(const Rig& rig) {
  const std::vector<PoseLoop> loops = contradicting_loops(rig);
  std::vector<Contradiction> found;
  if (loops.empty()) return found;
  if (!std::ranges::all_of(rig.poses, is_rotation)) {
    std::vector<PoseLoop> left = loops;
    std::erase_if(left, [&rig](const PoseLoop& loop) { return has_mirror(loop, rig); });
    add_unexplained(left, {}, found);
    return found;
  }
  const std::vector<Suspect> suspects = suspects_in(rig, loops);
  found = in_smaller_unit(rig, suspects);
  if (found.empty()) found = in_all_of_imu(rig, suspects);
  return found.empty() ? one_by_one(rig, loops) : found;
}

std::optional<Contradiction> outvoted_pose(const Rig& rig) {
  std::vector<Contradiction> found = contradictions(rig);
  if (found.size() != 1) return std::nullopt;
  const Blame blame = found.front().blame;
  if (blame != Blame::kOthersAgree && blame != Blame::kOrderOfPair) return std::nullopt;
  return std::move(found.front());
}

bool reports_contradiction(Code code) {
  return same_id(code, Code::kAnyPosesContradict) ||
         std::ranges::find(pose_mistakes(), code, &PoseMistake::code) != pose_mistakes().end();
}

bool is_too_long(double metres, std::string_view from, const Rig& rig) {
  constexpr double kLargeRig = 5.0;  // m
  constexpr double kLongVehicle = 20.0;
  return metres > (rig.kind_of(from) == FrameKind::kVehicle ? kLongVehicle : kLargeRig);
}

Rig without_pose(std::size_t edge, Rig rig) {
  rig.poses.erase(rig.poses.begin() + static_cast<std::ptrdiff_t>(edge));
  return rig;
}

}  // namespace fca
