// SPDX-License-Identifier: BSD-3-Clause
// The frames of a rig by numbers, and which poses join them: a search along names takes a hundred times as long.
#pragma once

#include <fca/rig/rig.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace fca::internal {

class FrameGraph {
 public:
  /// Of the poses, which are kept by reference.
  explicit FrameGraph(std::span<const PoseEdge> poses);

  /// A frame's number; nothing of one that no pose is of.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view frame) const;
  /// T_a_x of each frame x by its number, as Rig::resolve() has it. With `last` known, frames that are reached after that one
  /// may be left out.
  [[nodiscard]] std::vector<std::optional<Transform>> from(std::size_t a, std::optional<std::size_t> last = {}) const;

 private:
  /// A pose of the frame, as the other one is reached by it.
  struct Step {
    std::size_t to = 0;
    const PoseEdge* edge = nullptr;
    bool is_forwards = true;
  };

  std::unordered_map<std::string_view, std::size_t> numbers_;
  std::vector<std::vector<Step>> steps_;  ///< Of each frame, in the order of the poses.
};

}  // namespace fca::internal
