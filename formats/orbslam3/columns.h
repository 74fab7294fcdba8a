// SPDX-License-Identifier: BSD-3-Clause
// The columns of a fisheye pair's images between which ORB-SLAM3 matches: computed, or set by hand in a file that is edited.
#pragma once

#include "settings.h"

#include <fca/diagnostics.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca::orbslam3 {

/// Is the target a fisheye pair, between whose cameras ORB-SLAM3 matches only in columns that both see, and there are none?
[[nodiscard]] bool shares_no_columns(const Rig& rig, const Target& target);

/// A column that bounds what one camera sees in common with the other, as it follows from their poses and fields of view.
struct OverlapColumn {
  const TuningKey* key = nullptr;
  std::size_t camera = 0;  ///< Of whose image: the first or the second.
  int computed = 0;
};
/// Those that the target specifies; empty where it specifies none. Where the cameras share nothing, the whole width.
[[nodiscard]] std::vector<OverlapColumn> overlap_columns(const Rig& rig, const Target& target);

/// Which of the base's cameras the first and the second are, where their images have the same columns; `replaced`:
/// WriteOptions'.
[[nodiscard]] std::array<std::optional<std::size_t>, 2> same_images(const Rig& base, const Rig& rig,
                                                                    std::span<const std::string> replaced);

/// Columns that the new cameras would have otherwise, and those that somebody set by hand and that are true of other images
/// alone: kept or not, it is said.
void report_columns(const Rig& base, const Target& of_base, const Rig& rig, const Target& target,
                    std::span<const std::string> replaced, Diagnostics& diagnostics);

}  // namespace fca::orbslam3
