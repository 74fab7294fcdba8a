// SPDX-License-Identifier: BSD-3-Clause
// What the user wants fixed in a fit.
#pragma once

#include "fit_domain.h"

#include <fca/convert/convert.h>

#include <optional>

namespace fca::internal {

/// The options with a range for each parameter that is fixed at a number or as the source has it. Nothing, with an error, where
/// source or target has no such parameter.
[[nodiscard]] std::optional<ConvertOptions> with_fixed(const Camera& source, const ModelInfo& target, ConvertOptions options,
                                                       Diagnostics& diagnostics);

/// fit_domain(), with options.fixed.one_focal_length too: the best of the fits with fx = fy = f, by a golden-section search
/// for f.
[[nodiscard]] DomainFit fit_fixed(const FitTask& task);

}  // namespace fca::internal
