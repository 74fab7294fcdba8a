// SPDX-License-Identifier: BSD-3-Clause
// Fits with parameters that the user fixes (ConvertOptions::fixed).
#pragma once

#include "fit_field_of_view.h"

#include <fca/convert/convert.h>

#include <optional>

namespace fca::internal {

/// Returns the options with an additional range of a single value for each parameter that options.fixed fixes at a number or
/// keeps as in the source. Returns nullopt and adds an error to `diagnostics` if a kept parameter is not a parameter of the
/// source's model, or if one focal length is requested for a target without fx and fy or for a source without a model.
[[nodiscard]] std::optional<ConvertOptions> with_fixed(const Camera& source, const ModelInfo& target, ConvertOptions options,
                                                       Diagnostics& diagnostics);

/// Like fit_field_of_view(), but with options.fixed.one_focal_length it finds the best fit with fx = fy = f, by a
/// golden-section search over f.
[[nodiscard]] FieldOfViewFit fit_fixed(const FitTask& task);

}  // namespace fca::internal
