// SPDX-License-Identifier: BSD-3-Clause
// The rotation, or rotation and translation, that brings the rays of one camera nearest to those of another.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/rig/transform.h>

#include <optional>

namespace fca::internal {

/// Begins with the solution of Wahba's problem for the weighted rays of sample() (Kabsch 1976: from a singular value
/// decomposition), which makes angles small, and ends, by Gauss-Newton steps, where the root mean square of the evaluated
/// errors is smallest: in pixels of `other`. A rotation without a distance. With one, a translation [m] too: of points at
/// `distance_m` from the reference's projection centre. Nothing where too few pixels have a ray in both.
[[nodiscard]] std::optional<Transform> best_rotation(const Lens& reference, const CameraModel& other,
                                                     const FieldOfView& field_of_view, std::optional<double> distance_m = {});

}  // namespace fca::internal
