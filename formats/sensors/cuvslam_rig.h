// SPDX-License-Identifier: BSD-3-Clause
// The rig files of cuVSLAM's other examples (NVlabs/PyCuVSLAM@f1fb2b8):
//
//   examples/realsense   stereo_cameras: a list of serial, left_camera and right_camera, each with transform: three rows
//                        of four numbers, p_rig = T p_camera [m]. The lenses come from the devices.
//   examples/tum         rgb_camera: focal_length [fx, fy], principal_point [cx, cy], image_width, image_height; no distortion.
//                        depth_camera: scale
//
// They are read, and written into, but no fresh one is written.
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/format.h>

#include <optional>

namespace fca::cuvslam_rig {

[[nodiscard]] bool is_rig(const text::Document& document);
[[nodiscard]] ProbeResult probe(const text::Document& document);

/// The cameras of the list are cam0, cam1, ...: left, right, left. Those have poses alone, in "rig".
[[nodiscard]] std::optional<Rig> read(const text::Document& document, Diagnostics& diagnostics);

/// The base with what `rig` says of its poses or of its camera; nothing where that is no rig of the base's, or another lens.
[[nodiscard]] std::optional<Written> edited(const text::Document& base, const Rig& rig);

}  // namespace fca::cuvslam_rig
