// SPDX-License-Identifier: BSD-3-Clause
// Conversion of a camera that has no model but a table of rays with their pixels (Camera::rays). A fit sees these rays alone:
// between them nothing is known of the lens.
#pragma once

#include <fca/convert/convert.h>

#include <optional>

namespace fca::internal {

/// Fits the model `target` to those of camera.rays that are inside options.max_angle_rad. If it cannot describe all of them
/// (radtan at 90 degrees), the fit takes the rays inside a cone about the axis, the largest in steps of 5 degrees that it
/// describes, and a warning says so. Errors are measured at the rays, with their weights; no bound is proven. Shares in the
/// report's coverage are shares of the rays, not of the image. Nothing, with an error, where no fit succeeds.
[[nodiscard]] std::optional<Conversion> convert_table(const Camera& camera, const ModelInfo& target,
                                                      const ConvertOptions& options, Diagnostics& diagnostics);

}  // namespace fca::internal
