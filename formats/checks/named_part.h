// SPDX-License-Identifier: BSD-3-Clause
// Where in a document a program's sentence, or a reader's, points to.
#pragma once

#include <fca/formats/format.h>
#include <fca/formats/text/document.h>

#include <cstddef>
#include <string_view>

namespace fca::checks {

/// The part of the document that a program's sentence names by its first words ("cam0/intrinsics: fu is ...", "Camera.fps is
/// ..."); null if it names none.
[[nodiscard]] const text::Node* named_in(const text::Document& document, std::string_view sentence);

/// The neighbour in its list with which the number at `offset` is to be exchanged so that the format reads the document; null
/// if there is none.
[[nodiscard]] const text::Node* exchanged_with(const text::Document& document, const Format& format, const ReadOptions& options,
                                               std::size_t offset);

}  // namespace fca::checks
