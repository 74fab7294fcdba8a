// SPDX-License-Identifier: BSD-3-Clause
// What was converted, put into its places.
#pragma once

#include "commands/convert/outcome.h"
#include "console.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fca::cli {

/// Refuses before anything is written that two outputs have one path.
[[nodiscard]] bool collide(const std::vector<ConvertOutcome>& outcomes, const Console& console);

/// Removes what killed programs have left beside the outputs.
void remove_leftovers_beside(const std::vector<ConvertOutcome>& outcomes);

/// Writes the first of the outcomes, as many as have their files open at the same time; says in an outcome what went wrong with
/// it. Returns how many were tried.
[[nodiscard]] std::size_t write_outputs(const ConvertArguments& arguments, std::span<ConvertOutcome> outcomes,
                                        const Console& console);

}  // namespace fca::cli
