// SPDX-License-Identifier: BSD-3-Clause
// transforms.json: the cameras and the poses of images of a radiance field.
//
// Who reads it: nerfstudio@50e0e3c7 (2025-07-28, nerfstudio_dataparser.py, cameras.py), instant-ngp@abe236e (2026-02-02,
// nerf_loader.cu). What stands in it:
//
//   camera_model    nerfstudio's name of the lens; none: OPENCV
//   is_fisheye      instant-ngp's
//   fl_x fl_y cx cy w h   pixels; the centre of the first one is (0.5, 0.5), so that cx and cy are 0.5 larger than ours
//   k1 k2 k3 p1 p2  radtan; of a fisheye k1 k2 k3 k4
//   distortion_params  nerfstudio's list of k1 k2 k3 k4 p1 p2, which it takes before these
//   frames          for each image file_path, transform_matrix = T_world_cam diag(1, -1, -1, 1), and any of the intrinsics
//
// A number at the top is that of every image; else it stands in each frame. Frames with the same numbers are of one camera.
// Their poses are those of images in the world, not of cameras on a rig: they are kept and no part of the rig.
#pragma once

#include <fca/formats/format.h>

namespace fca::nerfstudio {

extern const Format kFormat;

}  // namespace fca::nerfstudio
