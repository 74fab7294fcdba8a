// SPDX-License-Identifier: BSD-3-Clause
// What two cameras of a rig both see.
#pragma once

#include <fca/rig/rig.h>

#include <numbers>
#include <optional>

namespace fca {

/// Columns of an image, both ends included.
struct ColumnRange {
  int first = 0;
  int last = 0;
  bool operator==(const ColumnRange&) const = default;
};

/// The columns of `camera`'s image between the first and the last in which a pixel shows a far point that `other` sees, too:
/// far against their distance, so that only the rotation of T_other_camera counts. Found on a lattice of 33 x 33 pixels, by
/// bisection between its columns, and then row by row: only a part apart that is narrower than a 32nd of the image may be
/// missed. Nothing if there is no such column, or an image size is not known. `max_angle_rad`: what counts as lens of either,
/// from its axis.
[[nodiscard]] std::optional<ColumnRange> columns_shared(const Camera& camera, const Camera& other,
                                                        const Transform& T_other_camera,
                                                        double max_angle_rad = std::numbers::pi);

/// Is there such a column?
[[nodiscard]] bool share_columns(const Camera& camera, const Camera& other, const Transform& T_other_camera,
                                 double max_angle_rad = std::numbers::pi);

}  // namespace fca
