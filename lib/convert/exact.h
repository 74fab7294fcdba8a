// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

#include <optional>
#include <string_view>

namespace fca::internal {

/// Of the model that has a skew besides (skewed.h); the id itself of any other.
[[nodiscard]] std::string_view id_without_skew(std::string_view id);

/// The same camera in a model that contains it, in closed form; nothing where a fit is needed. Besides the model itself, and
/// any chain of these:
///
///   pinhole                        -> radtan, ucm, ocamcalib (a0 alone), and back where the rest is zero; <- eucm with alpha =
///   0 radtan                         -> rational, and back where k4 = k5 = k6 = 0 radtan with k3 = 0            <-> mei with
///   xi = 0 ucm                            -> eucm (beta = 1), ds (xi = 0), mei without distortion, and back where that is so
///   ds with alpha = 0, xi > 0      -> ucm
///   ucm with alpha = 1/2           -> ocamcalib (a0, a2)
///   kb4 with k2 = k3 = k4 = 0     <-> woodscape with k2 = k4 = 0
[[nodiscard]] std::optional<CameraModel> convert_exactly(const CameraModel& source, std::string_view target_id);

/// A camera of the outer model (which contains the inner one's) that is that camera: convert_exactly or, where only a limit of
/// the outer model is (mei of ucm with alpha = 1), the furthest that a fit may go towards it.
[[nodiscard]] std::optional<CameraModel> convert_nearly(const CameraModel& inner, std::string_view outer_id);

/// The id of the largest model that the model of that id contains for all of its parameters (but alpha = 1 in mei:
/// convert_nearly); empty if there is none.
[[nodiscard]] std::string_view contained_model(std::string_view id);

}  // namespace fca::internal
