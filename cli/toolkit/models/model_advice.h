// SPDX-License-Identifier: BSD-3-Clause
// Suggests other models for a camera whose conversion is not good enough.
#pragma once

#include "convert/choose_model.h"

#include <optional>
#include <span>

namespace fca {

/// True if conversion `a` is better than `b`: it covers more of the image or, if both cover about the same part, its rms error
/// is smaller.
[[nodiscard]] bool is_better(const ConversionReport& a, const ConversionReport& b);

/// Returns "OpenCV reads kb4 (exact) and rational (up to 88 deg, rms 0.218 px)": the best three models that are better than
/// `report` (see is_better) and that `program` reads in the format. The message also names a model that only other programs
/// read, if that is much better. The function fits every model.
[[nodiscard]] Message better_models(const Camera& camera, const ConversionReport& report, const Format& format,
                                    std::string_view program, const ModelChoice& choice);

/// Returns a message Code::kOlderVersionsRead with the best of the models that all versions of the format's program read, and
/// with the errors of the camera that this model fits worst. nullopt if no such model fits all cameras.
[[nodiscard]] std::optional<Message> best_model_readable_by_all_versions(std::span<const Camera> cameras, const Format& format,
                                                                         const ModelChoice& choice);

/// True if users should know of a fit to the image's inscribed circle: inside the circle, its rms `circle_px` is less than half
/// of the rms `whole_px` of the fit to the whole lens.
[[nodiscard]] constexpr bool is_worth_a_nearer_fit(double whole_px, double circle_px) { return circle_px < 0.5 * whole_px; }

}  // namespace fca
