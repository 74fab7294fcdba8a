// SPDX-License-Identifier: BSD-3-Clause
#include "matching.h"

#include <algorithm>
#include <map>

namespace fca::internal {

namespace {

template <class Thing>
std::vector<Match> match(const std::vector<Thing>& reference, const std::vector<Thing>& other, bool by_order) {
  std::vector<Match> matches;
  for (std::size_t i = 0; i < reference.size() && !by_order; ++i) {
    const auto same = std::ranges::find(other, reference[i].name, &Thing::name);
    if (same != other.end()) matches.push_back({i, static_cast<std::size_t>(same - other.begin())});
  }
  if (!matches.empty()) return matches;
  for (std::size_t i = 0; i < std::min(reference.size(), other.size()); ++i) matches.push_back({i, i});
  return matches;
}

}  // namespace

Matching match(const Rig& reference, const Rig& other, bool by_order) {
  return {match(reference.cameras, other.cameras, by_order), match(reference.imus, other.imus, false)};
}

std::vector<PoseEdge> renamed_poses(const Rig& reference, const Rig& other, const Matching& matching) {
  std::map<std::string, std::string> names;
  // No file has such a name for a frame.
  for (const Camera& camera : other.cameras) names[camera.name] = "\n" + camera.name;
  for (const Imu& imu : other.imus) {
    // A camchain specifies poses in imu0 and nothing else of it.
    if (std::ranges::find(reference.imus, imu.name, &Imu::name) != reference.imus.end()) names[imu.name] = "\n" + imu.name;
  }
  for (const Match& match : matching.cameras) names[other.cameras[match.other].name] = reference.cameras[match.reference].name;
  // A frame of the other's that is none of its cameras (EuRoC's file of cam1 specifies T_Cam0) may have the name that one got.
  for (const Match& match : matching.cameras) {
    const std::string& taken = reference.cameras[match.reference].name;
    names.emplace(taken, "\n" + taken);
  }
  for (const Match& match : matching.imus) names[other.imus[match.other].name] = reference.imus[match.reference].name;
  const auto renamed = [&names](const std::string& name) {
    const auto found = names.find(name);
    return found == names.end() ? name : found->second;
  };
  std::vector<PoseEdge> poses = other.poses;
  for (PoseEdge& edge : poses) {
    edge.a = renamed(edge.a);
    edge.b = renamed(edge.b);
  }
  return poses;
}

}  // namespace fca::internal
