// SPDX-License-Identifier: BSD-3-Clause
// Which model a camera's distortion coefficients are of.
#pragma once

#include "layout.h"

#include "../fields.h"

#include <fca/formats/format.h>

#include <optional>
#include <span>
#include <string_view>

namespace fca::opencv {

/// The camera's model with its coefficients, the camera matrix still to be read. Nothing, with an error, where four numbers are
/// ambiguous or their count is nobody's. `map`: the mapping that holds the camera's keys.
[[nodiscard]] std::optional<CameraModel> read_lens(const Layout& layout, const CameraKeys& keys, const text::Node& map,
                                                   const ReadOptions& options, fields::Reader& reader);

/// The id of the simplest model that has these coefficients, kOpenCvCoefficients as far as they go: a vector of 12 or 14 that
/// ends in zeros is that of a shorter one.
[[nodiscard]] std::string_view model_of_coefficients(std::span<const double> D);

/// "camera_0 camera_matrix"
[[nodiscard]] std::string label(const CameraKeys& keys, std::string_view key);

}  // namespace fca::opencv
