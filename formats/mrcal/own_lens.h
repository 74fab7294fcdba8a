// SPDX-License-Identifier: BSD-3-Clause
// Lenses of mrcal that no model here is (dkogan/mrcal@c47576e of 2026-06-30, mrcal.c): STEREOGRAPHIC, LONLAT, LATLON, CAHVOR
// and SPLINED_STEREOGRAPHIC. They are read as tables of rays. CAHVORE has no centre of projection, and is not read.
#pragma once

#include <fca/convert/evaluate.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace fca::mrcal {

/// How many numbers such a lens has, fx fy cx cy first; nothing where the name is of none.
[[nodiscard]] std::optional<std::size_t> numbers_of_own_lens(std::string_view name);

/// Its pixel of a ray: nothing beyond what its knots were fitted to, or behind. `numbers`: as many as it has; they must outlive
/// the function.
[[nodiscard]] Projection projection_of_own_lens(std::string_view name, std::span<const double> numbers);

}  // namespace fca::mrcal
