// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rig/rig.h>

#include <optional>

namespace fca {

/// The image into which a program rectifies a camera's by values of its file: ROS image_proc by R and P.
struct RectifiedImage {
  Camera camera;                 ///< A pinhole.
  Transform T_rectified_camera;  ///< A rotation.
};

/// Of a camera_info whose R or P says another camera than its K; nothing of any other file, nor of images that are a part of
/// the sensor's.
[[nodiscard]] std::optional<RectifiedImage> rectified_image(const Rig& rig, const Camera& camera);

}  // namespace fca
