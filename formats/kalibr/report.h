// SPDX-License-Identifier: BSD-3-Clause
// Kalibr's report in words: results-cam.txt of kalibr_calibrate_cameras (CameraUtils.py, printParameters) and
// results-imucam.txt of kalibr_calibrate_imu_camera (IccUtil.py, printResultTxt).
//
//   cam0 (/topic):
//       type: <class '....DistortedPinholeCameraGeometry'>
//       distortion: [k1 k2 p1 p2] +- [...]            standard deviations, without correlations
//       projection: [fu fv pu pv] +- [...]            those of the intrinsics of the camchain, in its order
//       reprojection error: [u, v] +- [u, v]          mean and standard deviation, px; may be missing
//   baseline T_1_0:                                   T_cam1_cam0
//       q: [x y z w] +- [...]                         a rotation vector's [rad], in the frame of cam1
//       t: [x y z] +- [...]                           m
//
// The second file specifies the reprojection errors alone, "Reprojection error (cam0) [px]: mean 0.2, median 0.2, std: 0.1";
// what follows in it the camchain-imucam.yaml specifies, too.
#pragma once

#include <fca/formats/text/document.h>
#include <fca/rig/rig.h>

namespace fca::kalibr {

/// Does the text begin as such a report does?
[[nodiscard]] bool is_report(const text::Document& document);

/// Adds the uncertainties that it specifies. Errors stand at their places.
void read_report(const text::Document& document, Rig& rig, Diagnostics& diagnostics);

}  // namespace fca::kalibr
