// SPDX-License-Identifier: BSD-3-Clause
#include "frame_graph.h"

namespace fca::internal {

FrameGraph::FrameGraph(std::span<const PoseEdge> poses) {
  numbers_.reserve(2 * poses.size());
  for (const PoseEdge& edge : poses) {
    const std::size_t a = numbers_.try_emplace(edge.a, numbers_.size()).first->second;
    const std::size_t b = numbers_.try_emplace(edge.b, numbers_.size()).first->second;
    steps_.resize(numbers_.size());
    if (a == b) continue;
    steps_[a].push_back({b, &edge, true});
    steps_[b].push_back({a, &edge, false});
  }
}

std::optional<std::size_t> FrameGraph::find(std::string_view frame) const {
  const auto found = numbers_.find(frame);
  return found != numbers_.end() ? std::optional(found->second) : std::nullopt;
}

std::vector<std::optional<Transform>> FrameGraph::from(std::size_t a, std::optional<std::size_t> last) const {
  std::vector<std::optional<Transform>> reached(steps_.size());
  reached[a] = Transform{};
  // Breadth first.
  std::vector<std::size_t> queue = {a};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::size_t here = queue[next];
    if (here == last) break;
    for (const Step& step : steps_[here]) {
      if (reached[step.to]) continue;
      const std::optional<Transform> T_here_next =
          step.is_forwards ? std::optional(step.edge->T_a_b) : inverse(step.edge->T_a_b);
      if (!T_here_next) continue;
      reached[step.to] = *reached[here] * *T_here_next;
      queue.push_back(step.to);
    }
  }
  return reached;
}

}  // namespace fca::internal
