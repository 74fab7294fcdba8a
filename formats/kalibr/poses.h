// SPDX-License-Identifier: BSD-3-Clause
// Poses that a camera's block specifies, each in its own direction.
#pragma once

#include <fca/formats/text/document.h>
#include <fca/rig/rig.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::kalibr {

/// The key of a statement T_a_b and its frames.
struct PoseKey {
  std::string key;
  std::string a;
  std::string b;
};

/// The keys that the block of that camera may hold, in the order in which they are read. T_imu_cam is OpenVINS'.
[[nodiscard]] std::vector<PoseKey> pose_keys(const std::string& camera);

/// A top-level T_cam1_cam0; nothing if the key is none.
[[nodiscard]] std::optional<PoseKey> named_pose_key(const std::string& key);

/// Adds what a file specifies under the key.
void add_pose(const PoseKey& pose, const Transform& T, Rig& rig);

/// T_a_b as the rig specifies it, else as it follows from what it specifies.
[[nodiscard]] std::optional<Transform> pose_in(const Rig& rig, std::string_view a, std::string_view b);

/// Must a file that says `said` say T_a_b, too, to say what the rig says? Not what follows from it already.
[[nodiscard]] bool lacks_pose(const Rig& said, const Rig& rig, std::string_view a, std::string_view b);

}  // namespace fca::kalibr
