// SPDX-License-Identifier: BSD-3-Clause
// How much of the world a camera's image shows.
#pragma once

#include <fca/rig/rig.h>

#include <numbers>
#include <optional>

namespace fca {

/// In radians; nothing where the image size is not known or a border has no ray. Where the image holds the principal point they
/// are taken by way of the axis, and may be more than pi; else, as in a crop, they are angles between two rays.
struct FieldsOfView {
  std::optional<double> horizontal;         ///< Along the row through the principal point, or the image's nearest to it.
  std::optional<double> vertical;           ///< Along the column through it, or the nearest.
  std::optional<double> diagonal;           ///< From the top-left to the bottom-right corner.
  std::optional<double> largest_from_axis;  ///< Among the pixels that have a ray.
};

[[nodiscard]] std::optional<double> horizontal_field_of_view(const Camera& camera);

/// All of them. `limit`: what counts as lens, in radians from the axis; a border beyond it, or outside the camera's lens
/// circle, has no ray.
[[nodiscard]] FieldsOfView fields_of_view(const Camera& camera, double limit = std::numbers::pi);

}  // namespace fca
