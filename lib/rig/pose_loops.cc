// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/pose_loops.h>

#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace fca {

namespace {

struct Path {
  Transform T;
  std::vector<std::size_t> edges;
};

/// The shortest path from a to b that leaves out one edge; of equally short ones that whose edges were read first, as
/// Rig::resolve has it.
std::optional<Path> path_without(std::size_t edge, std::span<const PoseEdge> poses) {
  const std::string& a = poses[edge].a;
  const std::string& b = poses[edge].b;
  std::map<std::string, Path> reached;
  reached.emplace(a, Path{});
  std::deque<std::string> queue = {a};
  while (!queue.empty()) {
    const std::string here = queue.front();
    queue.pop_front();
    const Path so_far = reached.at(here);
    if (here == b) return so_far;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const bool forwards = poses[i].a == here;
      if (i == edge || (!forwards && poses[i].b != here)) continue;
      const std::string& next = forwards ? poses[i].b : poses[i].a;
      if (reached.contains(next)) continue;
      const std::optional<Transform> T = forwards ? std::optional(poses[i].T_a_b) : inverse(poses[i].T_a_b);
      if (!T) continue;
      Path path{so_far.T * *T, so_far.edges};
      path.edges.push_back(i);
      reached.emplace(next, std::move(path));
      queue.push_back(next);
    }
  }
  return std::nullopt;
}

std::optional<PoseLoop> loop_of(std::size_t edge, std::span<const PoseEdge> poses) {
  std::optional<Path> path = path_without(edge, poses);
  if (!path) return std::nullopt;
  const PoseDifference difference = difference_of(path->T, poses[edge].T_a_b);
  return PoseLoop{edge, std::move(path->edges), path->T, difference};
}

}  // namespace

bool PoseDifference::contradicts() const {
  constexpr double kTolerance = 1e-3;  // rad, m; an element of a matrix that is no rotation
  return angle_rad > kTolerance || distance_m > kTolerance || largest_element > kTolerance;
}

PoseDifference difference_of(const Transform& a, const Transform& b) {
  PoseDifference difference{angle_between(a, b), distance_between(a, b), 0.0};
  for (std::size_t i = 0; i < a.values.size(); ++i)
    difference.largest_element = std::max(difference.largest_element, std::abs(a.values[i] - b.values[i]));
  return difference;
}

std::vector<PoseLoop> pose_loops(const Rig& rig) {
  std::vector<PoseLoop> loops;
  for (std::size_t i = 0; i < rig.poses.size(); ++i) {
    if (std::optional<PoseLoop> loop = loop_of(i, std::span(rig.poses).first(i + 1))) loops.push_back(*std::move(loop));
  }
  return loops;
}

std::vector<PoseLoop> contradicting_loops(const Rig& rig) {
  std::vector<PoseLoop> loops = pose_loops(rig);
  std::erase_if(loops, [](const PoseLoop& loop) { return !loop.difference.contradicts(); });
  return loops;
}

std::optional<PoseLoop> pose_loop(std::size_t edge, const Rig& rig) { return loop_of(edge, rig.poses); }

std::set<std::size_t> edges_of(const std::vector<PoseLoop>& loops) {
  std::set<std::size_t> edges;
  for (const PoseLoop& loop : loops) {
    edges.insert(loop.edge);
    edges.insert(loop.path.begin(), loop.path.end());
  }
  return edges;
}

}  // namespace fca
