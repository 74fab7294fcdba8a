// SPDX-License-Identifier: BSD-3-Clause
// Converts a camera whose lens is a table of rays and pixels (Camera::rays) instead of a model. A fit uses only these rays: the
// lens is not known between them.
#pragma once

#include <fca/convert/convert.h>

#include <optional>

namespace fca::internal {

/// Fits the model `target` to the entries of camera.rays inside options.max_angle_rad. If the model cannot describe all of them
/// (radtan at 90 degrees), fits it up to the largest angle that it describes, in steps of 5 degrees, and adds a warning.
/// Errors are those of the table's rays, with the rays' weights; no bound is proven. Shares in the report's coverage are shares
/// of the rays, not of the image. nullopt, with an error, if no fit succeeds.
[[nodiscard]] std::optional<Conversion> convert_table(const Camera& camera, const ModelInfo& target,
                                                      const ConvertOptions& options, Diagnostics& diagnostics);

}  // namespace fca::internal
