// SPDX-License-Identifier: BSD-3-Clause
// Fits in which the user fixes parameters.
#pragma once

#include "fit_field_of_view.h"

#include <fca/convert/convert.h>

#include <optional>

namespace fca::internal {

/// Adds a range of one value to the options for each parameter that is fixed at a number or kept as in the source. nullopt,
/// with an error, if source or target has no such parameter.
[[nodiscard]] std::optional<ConvertOptions> with_fixed(const Camera& source, const ModelInfo& target, ConvertOptions options,
                                                       Diagnostics& diagnostics);

/// Like fit_field_of_view(), but obeys options.fixed.one_focal_length: finds the best fit with fx = fy = f by a golden-section
/// search for f.
[[nodiscard]] FieldOfViewFit fit_fixed(const FitTask& task);

}  // namespace fca::internal
