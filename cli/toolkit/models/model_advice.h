// SPDX-License-Identifier: BSD-3-Clause
// Which models would describe a lens better than one that cannot reach all of it.
#pragma once

#include "convert/choose_model.h"

#include <optional>
#include <span>

namespace fca {

/// Coverage first, then the error.
[[nodiscard]] bool is_better(const ConversionReport& a, const ConversionReport& b);

/// "OpenCV reads kb4 (exact) and rational (up to 88 deg, rms 0.218 px)": the best three of the models that `program`
/// reads of the format and that cover more of the image than `report` says, or as much with less error; and what other programs
/// read, where that is much better. All of them are fitted for this.
[[nodiscard]] Message better_models(const Camera& camera, const ConversionReport& report, const Format& format,
                                    std::string_view program, const ModelChoice& choice);

/// Code::kOlderVersionsRead: of the models that every version of the format's program reads the one that all cameras fit best,
/// and the error of the worst; nothing if there is none.
[[nodiscard]] std::optional<Message> best_of_every_version(std::span<const Camera> cameras, const Format& format,
                                                           const ModelChoice& choice);

/// Is a fit to the circle alone so much better there (rms in pixels, before and after) that people should hear of it?
[[nodiscard]] constexpr bool is_worth_a_nearer_fit(double whole_px, double circle_px) { return circle_px < 0.5 * whole_px; }

}  // namespace fca
