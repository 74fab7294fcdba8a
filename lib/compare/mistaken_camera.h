// SPDX-License-Identifier: BSD-3-Clause
// Mistakes by which a right camera becomes a wrong one.
#pragma once

#include <fca/compare/report.h>
#include <fca/convert/field_of_view.h>
#include <fca/rig/rig.h>

#include <optional>

namespace fca::internal {

/// An explanation leaves no more than this share of the difference.
inline constexpr double kExplained = 0.05;

/// The mistake that explains how `other` (in the reference's pixels; `scale`: reference's pixels per pixel of its own) differs;
/// nothing where the two are the same or none explains it.
[[nodiscard]] std::optional<Mistake> mistake_in(const Camera& reference, const Camera& other, double scale,
                                                const CameraDifference& difference, const FieldOfView& field_of_view);

}  // namespace fca::internal
