// SPDX-License-Identifier: BSD-3-Clause
// Entries of the loss ledger that every writer makes alike.
#pragma once

#include <fca/formats/format.h>

#include <span>
#include <string_view>
#include <vector>

namespace fca {

/// What was read and has no place in the target, each as a loss; keys of one group ("Viewer.PointSize", ...) as one.
void add_not_carried(std::span<const AsRead> extras, std::string_view why, std::vector<Loss>& losses);

/// Those of `extras` that the base they are written into does not itself state.
[[nodiscard]] std::vector<AsRead> not_in_base(std::span<const AsRead> extras, std::span<const AsRead> base);

}  // namespace fca
