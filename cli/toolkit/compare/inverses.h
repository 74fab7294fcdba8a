// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/calibration.h>

#include <optional>

namespace fca {

/// Returns the value of ComparedFile::inverse_px: the largest distance [px] between the pixels to which the OCamCalib inverse
/// polynomials (world2cam) of two files project the same ray, over the rays of the reference's image. If only one of them
/// projects a ray, the image's diagonal. nullopt if a file has no inverse polynomial, or if the image sizes differ.
[[nodiscard]] std::optional<double> inverse_distance_px(const Calibration& reference, const Calibration& other);

}  // namespace fca
