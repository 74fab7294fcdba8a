// SPDX-License-Identifier: BSD-3-Clause
// VINS-Mono and VINS-Fusion: camera files of camodocal (HKUST-Aerial-Robotics/VINS-Fusion,
// camera_models/src/camera_models/*.cc), which cv::FileStorage reads. KITTI-360's image_02.yaml and image_03.yaml are such
// files, too.
//
//   model_type             PINHOLE, PINHOLE_FULL, MEI, KANNALA_BRANDT, spelled exactly so; scaramuzza in any case
//   camera_name
//   image_width, image_height
//   mirror_parameters      MEI: xi
//   distortion_parameters  PINHOLE, MEI: k1 k2 p1 p2; PINHOLE_FULL: k1 k2 k3 k4 k5 k6 p1 p2, OpenCV's names
//   projection_parameters  PINHOLE, PINHOLE_FULL: fx fy cx cy; MEI: gamma1 gamma2 u0 v0;
//                          KANNALA_BRANDT: k2 k3 k4 k5 (our k1 .. k4) mu mv u0 v0
//   poly_parameters        scaramuzza: p0 .. p4, inv_poly_parameters: p0 .. p19, affine_parameters: ac ad ae cx cy
//   (scaramuzza.h)
//
// camodocal reads a missing key as 0, and a model_type in another case as a camera of zeros, without a word.
#pragma once

#include <fca/formats/format.h>

namespace fca::vins {

extern const Format kFormat;

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace fca::vins
