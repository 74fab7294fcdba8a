// SPDX-License-Identifier: BSD-3-Clause
// A lens that is known as a table: rays and their pixels, from a measurement or another program.
#pragma once

#include <fca/convert/judge.h>
#include <fca/models/model_traits.h>

#include <optional>
#include <span>

namespace fca {

/// The centre of the lens by the quarter of the table (six entries at least) that is closest to the axis: least squares of
/// pixel = centre + focal length times angle, along u and along v. Nothing where that does not determine them.
[[nodiscard]] std::optional<LensCentre> centre_of(std::span<const Correspondence> table);

/// How far `target` is from the table, by the entries' weights; those it has no pixel for are left out. There is no bound.
[[nodiscard]] ErrorSummary judge(std::span<const Correspondence> table, const Projection& target);

}  // namespace fca
