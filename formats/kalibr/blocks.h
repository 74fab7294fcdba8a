// SPDX-License-Identifier: BSD-3-Clause
// The tables of a camera's block and of an imu.yaml.
#pragma once

#include "../schema/schema.h"

#include <optional>
#include <string>
#include <vector>

namespace fca::kalibr {

/// Keys that become members of a Camera and its poses. Those of the lens have no reader of their own: they are read together.
extern const schema::Mapping kCameraBlock;
extern const schema::Mapping kImuBlock;
/// A chain of such blocks. OpenVINS' are OpenCV's YAML.
extern const schema::Schema kChain;
extern const schema::Schema kOpenCvChain;

/// The fields of a camera without its poses, in Kalibr's (alphabetic) order.
[[nodiscard]] std::vector<fields::Field> lens_fields(const Camera& camera);

/// All fields of the camera of that index in a fresh chain. `overlaps`: its cam_overlaps, if it is known.
[[nodiscard]] std::vector<fields::Field> camera_fields(const Rig& rig, std::size_t index,
                                                       const std::optional<fields::Field>& overlaps);

/// The fields of an imu.yaml.
[[nodiscard]] std::vector<fields::Field> imu_fields(const Imu& imu);

/// Keys of an imu.yaml for numbers that the IMU lacks. `rate`: is that one wanted, too?
[[nodiscard]] std::vector<std::string> missing_in(const Imu& imu, bool rate);

/// Does the mapping hold one of imu.yaml's noise keys?
[[nodiscard]] bool holds_noise(const text::Node& mapping);

}  // namespace fca::kalibr
