// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <string>

namespace fca {

/// Two cameras, and what their files state of their rectification.
struct SourcePair {
  std::array<Camera, 2> cameras;
  Transform T_second_first;
  std::optional<RectifiedPair> stated;  ///< Of these two, in this order.
  bool is_rectified = false;            ///< The files hold the camera of rectified images alone, and their baseline.
};

/// Of the rig's cameras those that are a pair. Nothing, with an error at `file`, where there is none.
[[nodiscard]] std::optional<SourcePair> source_pair(const Rig& rig, const std::string& file, Diagnostics& diagnostics);

}  // namespace fca
