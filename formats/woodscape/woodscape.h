// SPDX-License-Identifier: BSD-3-Clause
// WoodScape: one JSON per camera (valeoai/WoodScape, scripts/calibration/projection.py and calibration.txt).
//
//   intrinsic   aspect_ratio, cx_offset, cy_offset, height, k1 .. k4 [px / rad^i], model "radial_poly", poly_order 4, width
//               principal point = size / 2 - 0.5 + offset; aspect_ratio multiplies v only
//   extrinsic   quaternion x y z w and translation [m]: p_vehicle = R p_camera + t; vehicle: ISO 8855, x forward, y left, z up
//   name        "FV", "RV", "MVL", "MVR"
//
// omnidet, the dataset's other program, takes the values of intrinsic by their place: the order of the keys is part of the
// format.
#pragma once

#include <fca/formats/format.h>

namespace fca::woodscape {

extern const Format kFormat;

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace fca::woodscape
