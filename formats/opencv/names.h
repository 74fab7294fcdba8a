// SPDX-License-Identifier: BSD-3-Clause
// What keys are called: the same few words in many spellings ("cameraMatrixL", "left_camera_matrix", "M1").
#pragma once

#include <string>
#include <string_view>

namespace fca::opencv {

enum class Role { kNone, kMatrix, kDistortion, kRadial, kTangential, kXi };

/// A key that speaks of one camera.
struct Name {
  Role role = Role::kNone;
  std::string side;      ///< Which camera: "", "1", "l", "left", ...
  bool fisheye = false;  ///< The key itself says fisheye.
};

/// Role::kNone for any other key.
[[nodiscard]] Name name_of(std::string_view key);

/// The distortion's key that goes with a matrix's key where the file has none: "M1" -> "D1"; "" where no program would look.
[[nodiscard]] std::string distortion_key_for(std::string_view matrix_key);

}  // namespace fca::opencv
