// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

#include <optional>
#include <string_view>

namespace fca::internal {

/// The same camera in a model that contains it, in closed form: the model itself, ucm -> eucm (beta = 1), ds (xi = 0) and mei;
/// eucm with beta = 1, ds with xi = 0 and undistorted mei -> ucm and on from there; pinhole -> radtan, kin with alpha = 0, and
/// undistorted radtan -> pinhole; radtan -> rational, and rational with k4 = k5 = k6 = 0 -> radtan; radtan with k3 = 0 -> mei
/// (xi = 0) and back; pinhole -> ocamcalib (a0 alone) and back. Nothing where a fit is needed.
[[nodiscard]] std::optional<CameraModel> convert_exactly(const CameraModel& source, std::string_view target_id);

/// The id of the largest model that the model of that id contains for all of its parameters (but alpha = 1 in mei); empty if
/// there is none.
[[nodiscard]] std::string_view contained_model(std::string_view id);

}  // namespace fca::internal
