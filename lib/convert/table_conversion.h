// SPDX-License-Identifier: BSD-3-Clause
// Conversion of a lens that is known as a table of rays and pixels: there is nothing to sample, and nothing between them.
#pragma once

#include <fca/convert/convert.h>

#include <optional>

namespace fca::internal {

/// Fits `target` to camera.rays inside options.max_angle_rad. Where it cannot describe all of them, to those inside the largest
/// cone in steps of 5 degrees on which it can, with a warning. Errors are the table's, by its weights; there is no bound.
/// Shares of the report's coverage are shares of the table.
[[nodiscard]] std::optional<Conversion> convert_table(const Camera& camera, const ModelInfo& target,
                                                      const ConvertOptions& options, Diagnostics& diagnostics);

}  // namespace fca::internal
