// SPDX-License-Identifier: BSD-3-Clause
// Cameras to look through into another one's image.
#pragma once

#include <fca/rig/rig.h>
#include <fca/rig/transform.h>

namespace fca {

/// A pinhole camera with square pixels and its axis in the middle of the image. `full_fov_rad`: what it sees from its left
/// border to its right one (of the pixels' outer edges), in (0, pi).
[[nodiscard]] CameraModel pinhole_of_view(const ImageSize& size, double full_fov_rad);

/// The ray of a pixel of an image that shows all directions (equirectangular): columns are longitudes, atan2(x, z) from -pi at
/// the image's left border to pi at its right one; rows are latitudes, from straight up at its upper border to straight down at
/// its lower one. The axis is in the middle. Borders are the outer edges of the pixels: COLMAP's EQUIRECTANGULAR, half a pixel
/// apart.
[[nodiscard]] Ray equirectangular_ray(const ImageSize& size, const Pixel& pixel);

/// T_old_new of a camera that is turned about its own axes (x right, y down, z forward), in radians, right-handed: first by
/// `yaw` about y (positive: to the right), then by `pitch` about the new x (positive: up), then by `roll` about the new z
/// (positive: clockwise, seen from behind). R_old_new = Ry(yaw) Rx(pitch) Rz(roll).
[[nodiscard]] Transform turned(double yaw, double pitch, double roll);

}  // namespace fca
