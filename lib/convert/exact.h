// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

#include <optional>
#include <string_view>

namespace fca::internal {

/// The same camera in a model that contains it, in closed form: the model itself, ucm -> eucm (beta = 1), ds (xi = 0) and mei;
/// eucm with beta = 1, ds with xi = 0 and undistorted mei -> ucm and on from there; pinhole -> radtan, kin with alpha = 0, and
/// undistorted radtan -> pinhole. Nothing where a fit is needed.
[[nodiscard]] std::optional<CameraModel> convert_exactly(const CameraModel& source, std::string_view target_id);

}  // namespace fca::internal
