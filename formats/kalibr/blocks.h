// SPDX-License-Identifier: BSD-3-Clause
// What a camera's block and an imu.yaml say, key by key.
#pragma once

#include "../fields.h"

#include <fca/rig/rig.h>

#include <optional>
#include <vector>

namespace fca::kalibr {

/// The fields of a camera without its poses, in Kalibr's (alphabetic) order.
[[nodiscard]] std::vector<fields::Field> lens_fields(const Camera& camera);

/// All fields of the camera of that index in a fresh chain. `overlaps`: its cam_overlaps, if it is known.
[[nodiscard]] std::vector<fields::Field> camera_fields(const Rig& rig, std::size_t index,
                                                       const std::optional<fields::Field>& overlaps);

/// The fields of an imu.yaml.
[[nodiscard]] std::vector<fields::Field> imu_fields(const Imu& imu);

}  // namespace fca::kalibr
