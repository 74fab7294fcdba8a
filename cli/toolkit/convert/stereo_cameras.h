// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

#include <cstddef>
#include <optional>

namespace fca {

/// Two of the converted cameras, by their indices.
struct StereoCameras {
  std::size_t first = 0;
  std::size_t second = 0;
  Transform T_second_first;  ///< As the input has it.
};

/// The stereo pair among them, by the poses of the input. Nothing where there is none, or no pose between the two.
[[nodiscard]] std::optional<StereoCameras> stereo_cameras(const Rig& input, const std::vector<ConvertedCamera>& cameras);

}  // namespace fca
