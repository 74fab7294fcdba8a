// SPDX-License-Identifier: BSD-3-Clause
// A lens that is known as a table: rays and their pixels, from a measurement or another program.
#pragma once

#include <fca/convert/evaluate.h>
#include <fca/models/model_traits.h>

#include <optional>
#include <span>

namespace fca {

/// The centre of the lens by the quarter of the table (six entries at least) that is closest to the axis: least squares of
/// pixel = centre + focal length times angle, along u and along v. Nothing where that does not determine them.
[[nodiscard]] std::optional<LensCentre> centre_of(std::span<const Correspondence> table);

/// How far `target` is from the table, by the entries' weights; those it has no pixel for are left out. There is no bound.
[[nodiscard]] ErrorSummary evaluate(std::span<const Correspondence> table, const Projection& target);

/// The same with shares of the table in place of shares of an image, and what ends `field_of_view`.
[[nodiscard]] ErrorStatistics evaluate_table(std::span<const Correspondence> table, const FieldOfView& field_of_view,
                                             const Projection& target);

/// `camera`, whose lens is `projection` and no model of the list, as a table of up to 2,800 rays: about as many from its axis
/// in each direction, up to `max_angle_rad` or where the radius stops growing, of those whose pixel lies in the image; weights
/// are their shares of it. Nothing where the camera specifies no size, its axis has no pixel, or it sees fewer than
/// kFewestRays.
[[nodiscard]] std::optional<Camera> measured(Camera camera, const Projection& projection, double max_angle_rad);

/// Of a camera that is known by rays alone.
inline constexpr std::size_t kFewestRays = 20;

}  // namespace fca
