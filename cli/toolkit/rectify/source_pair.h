// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <string>

namespace fca {

/// Two cameras, and their rectification if the files contain one.
struct SourcePair {
  std::array<Camera, 2> cameras;
  Transform T_second_first;
  /// The rectification of these cameras in the files, with the cameras in this order. nullopt if the files contain none.
  std::optional<RectifiedPair> stated;
  bool is_rectified = false;  ///< The files only contain the baseline and one camera, that of the rectified images.
};

/// Finds the stereo pair among the cameras of a rig. nullopt, with an error at `file`, if there is none.
[[nodiscard]] std::optional<SourcePair> source_pair(const Rig& rig, const std::string& file, Diagnostics& diagnostics);

}  // namespace fca
