// SPDX-License-Identifier: BSD-3-Clause
// Suggests models for a lens that its model cannot describe completely.
#pragma once

#include "convert/choose_model.h"

#include <optional>
#include <span>

namespace fca {

/// True if `a` covers more of the image or, if both cover as much, has the smaller rms.
[[nodiscard]] bool is_better(const ConversionReport& a, const ConversionReport& b);

/// "OpenCV reads kb4 (exact) and rational (up to 88 deg, rms 0.218 px)": the best three models, of those that `program` reads
/// in the format, that cover more of the image than `report`, or as much with a smaller error. Also names a model that only
/// other programs read, if it is much better. Every model is fitted for this.
[[nodiscard]] Message better_models(const Camera& camera, const ConversionReport& report, const Format& format,
                                    std::string_view program, const ModelChoice& choice);

/// Code::kOlderVersionsRead: of the models that every version of the format's program reads, the one that fits best, with the
/// error of the camera that it fits worst; nullopt if there is none.
[[nodiscard]] std::optional<Message> best_of_every_version(std::span<const Camera> cameras, const Format& format,
                                                           const ModelChoice& choice);

/// True if a fit to the inscribed circle is so much better there that users should know: its rms [px] is below half of that of
/// the fit to the whole lens.
[[nodiscard]] constexpr bool is_worth_a_nearer_fit(double whole_px, double circle_px) { return circle_px < 0.5 * whole_px; }

}  // namespace fca
