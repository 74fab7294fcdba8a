// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

#include <cstddef>
#include <optional>

namespace fca {

/// The two cameras of a stereo pair.
struct StereoCameras {
  std::size_t first = 0;     ///< Its index in the list of converted cameras.
  std::size_t second = 0;    ///< The same for the second camera.
  Transform T_second_first;  ///< Takes points [m] from the first camera's frame to the second camera's frame, as in the input.
};

/// Finds the stereo pair among `cameras` by the poses of `input`. Returns nullopt if there is no pair. Tables of rays, and
/// cameras without an image size, cannot be in it.
[[nodiscard]] std::optional<StereoCameras> stereo_cameras(const Rig& input, const std::vector<ConvertedCamera>& cameras);

}  // namespace fca
