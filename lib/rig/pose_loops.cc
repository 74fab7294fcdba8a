// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/pose_loops.h>

#include "frame_graph.h"

#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace fca {

namespace {

/// The pose's loop with the shortest way by the others; nothing if there is none.
std::optional<PoseLoop> loop_of(std::size_t edge, std::span<const PoseEdge> poses) {
  const internal::FrameGraph graph(poses);
  const std::size_t a = graph.find(poses[edge].a).value();
  const std::size_t b = graph.find(poses[edge].b).value();
  std::optional<internal::FramePath> way = graph.path(a, b, edge);
  if (!way) return std::nullopt;
  const PoseDifference difference = difference_of(way->T, poses[edge].T_a_b);
  return PoseLoop{edge, std::move(way->poses), way->T, difference};
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
