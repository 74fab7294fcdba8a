// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

#include <cstddef>
#include <optional>

namespace fca {

/// Two of the converted cameras, by their indices in the list of all.
struct StereoCameras {
  std::size_t first = 0;
  std::size_t second = 0;
  Transform T_second_first;  ///< Maps points [m] from the first camera's frame to the second's, as in the input.
};

/// The stereo pair among `cameras`, found by the poses of `input`. Nothing if there is no pair, or no pose between its cameras.
[[nodiscard]] std::optional<StereoCameras> stereo_cameras(const Rig& input, const std::vector<ConvertedCamera>& cameras);

}  // namespace fca
