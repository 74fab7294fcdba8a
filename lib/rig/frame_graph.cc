// SPDX-License-Identifier: BSD-3-Clause
#include "frame_graph.h"

#include <algorithm>

namespace fca::internal {

FrameGraph::FrameGraph(std::span<const PoseEdge> poses) : poses_(poses) {
  numbers_.reserve(2 * poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::size_t a = numbers_.try_emplace(poses[i].a, numbers_.size()).first->second;
    const std::size_t b = numbers_.try_emplace(poses[i].b, numbers_.size()).first->second;
    steps_.resize(numbers_.size());
    if (a == b) continue;
    steps_[a].push_back({b, i, true});
    steps_[b].push_back({a, i, false});
  }
}

std::optional<std::size_t> FrameGraph::find(std::string_view frame) const {
  const auto found = numbers_.find(frame);
  return found != numbers_.end() ? std::optional(found->second) : std::nullopt;
}

/// Breadth-first.
std::vector<std::optional<FrameGraph::Arrival>> FrameGraph::search(std::size_t a, std::optional<std::size_t> last,
                                                                   std::optional<std::size_t> without) const {
  std::vector<std::optional<Arrival>> reached(steps_.size());
  reached[a] = Arrival{};
  std::vector<std::size_t> queue = {a};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::size_t here = queue[next];
    if (here == last) break;
    for (const Step& step : steps_[here]) {
      if (reached[step.to] || step.pose == without) continue;
      const Transform& T_a_b = poses_[step.pose].T_a_b;
      const std::optional<Transform> T_here_next = step.is_forwards ? std::optional(T_a_b) : inverse(T_a_b);
      if (!T_here_next) continue;
      reached[step.to] = Arrival{reached[here]->T * *T_here_next, here, step.pose};
      queue.push_back(step.to);
    }
  }
  return reached;
}

std::vector<std::optional<Transform>> FrameGraph::from(std::size_t a, std::optional<std::size_t> last) const {
  const std::vector<std::optional<Arrival>> reached = search(a, last, {});
  std::vector<std::optional<Transform>> transforms(reached.size());
  std::ranges::transform(reached, transforms.begin(),
                         [](const auto& each) { return each ? std::optional(each->T) : std::nullopt; });
  return transforms;
}

std::optional<FramePath> FrameGraph::path(std::size_t a, std::size_t b, std::size_t without) const {
  const std::vector<std::optional<Arrival>> reached = search(a, b, without);
  if (!reached[b]) return std::nullopt;
  FramePath path{reached[b]->T, {}};
  for (std::size_t frame = b; frame != a; frame = reached[frame]->before) path.poses.push_back(reached[frame]->pose);
  std::ranges::reverse(path.poses);
  return path;
}

}  // namespace fca::internal
