// SPDX-License-Identifier: BSD-3-Clause
// Which model a camera's distortion coefficients are of.
#pragma once

#include "layout.h"

#include "../fields.h"

#include <fca/formats/format.h>

#include <optional>

namespace fca::opencv {

/// The camera's model with its coefficients, the camera matrix still to be read. Nothing, with an error, where four numbers are
/// ambiguous or their count is nobody's. `map`: the mapping that holds the camera's keys.
[[nodiscard]] std::optional<CameraModel> read_lens(const Layout& layout, const CameraKeys& keys, const text::Node& map,
                                                   const ReadOptions& options, fields::Reader& reader);

/// "camera_0 camera_matrix"
[[nodiscard]] std::string label(const CameraKeys& keys, std::string_view key);

}  // namespace fca::opencv
