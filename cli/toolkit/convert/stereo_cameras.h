// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

#include <cstddef>
#include <optional>

namespace fca {

/// Indices of two of the converted cameras, and their relative pose.
struct StereoCameras {
  std::size_t first = 0;
  std::size_t second = 0;
  Transform T_second_first;  ///< As in the input.
};

/// The stereo pair among the cameras, by the poses of the input. nullopt if there is none, or no pose connects the two.
[[nodiscard]] std::optional<StereoCameras> stereo_cameras(const Rig& input, const std::vector<ConvertedCamera>& cameras);

}  // namespace fca
