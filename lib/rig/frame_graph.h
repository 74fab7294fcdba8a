// SPDX-License-Identifier: BSD-3-Clause
// The frames of a rig as numbers, and which poses join them: a search by names takes a hundred times as long.
#pragma once

#include <fca/rig/rig.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace fca::internal {

/// The shortest way from one frame to another.
struct FramePath {
  Transform T;                     ///< T_a_b: takes points of the last frame to the first.
  std::vector<std::size_t> poses;  ///< In the order of the way; places in the list of all.
};

class FrameGraph {
 public:
  /// Keeps a reference to the poses.
  explicit FrameGraph(std::span<const PoseEdge> poses);

  /// A frame's number; nothing if no pose has that frame.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view frame) const;
  /// T_a_x of each frame x, by its number; nothing where no poses lead. Of equally short ways the one whose poses come first
  /// counts. Poses that cannot be inverted where that is needed lead nowhere. If `last` is given, the search may end with that
  /// frame.
  [[nodiscard]] std::vector<std::optional<Transform>> from(std::size_t a, std::optional<std::size_t> last = {}) const;
  /// The way from a to b that does not use the pose `without`; nothing if there is none.
  [[nodiscard]] std::optional<FramePath> path(std::size_t a, std::size_t b, std::size_t without) const;

 private:
  /// A pose of a frame, and the other frame.
  struct Step {
    std::size_t to = 0;
    std::size_t pose = 0;
    bool is_forwards = true;  ///< The frame is the pose's a.
  };
  /// How a search came to a frame.
  struct Arrival {
    Transform T;  ///< T_a_x
    std::size_t before = 0;
    std::size_t pose = 0;
  };
  [[nodiscard]] std::vector<std::optional<Arrival>> search(std::size_t a, std::optional<std::size_t> last,
                                                           std::optional<std::size_t> without) const;

  std::span<const PoseEdge> poses_;
  std::unordered_map<std::string_view, std::size_t> numbers_;
  std::vector<std::vector<Step>> steps_;  ///< Of each frame, in the order of the poses.
};

}  // namespace fca::internal
