// SPDX-License-Identifier: BSD-3-Clause
// Two numbers of a list that stand in each other's place.
#pragma once

#include <fca/formats/format.h>
#include <fca/formats/text/document.h>

#include <cstddef>

namespace fca::checks {

/// The neighbour in its list with which the number at `offset` is to be exchanged so that the format reads the document; null
/// if there is none.
[[nodiscard]] const text::Node* exchanged_with(const text::Document& document, const Format& format, const ReadOptions& options,
                                               std::size_t offset);

}  // namespace fca::checks
