// SPDX-License-Identifier: BSD-3-Clause
// Where the comments of a document stand.
#pragma once

#include <fca/formats/text/document.h>

#include <vector>

namespace fca::text {

/// The comments of a document's source in their order: YAML's from '#' to the end of the line (without its line break), XML's
/// whole. JSON has none, and in documents of words such lines belong to the layout.
[[nodiscard]] std::vector<Span> comments_of(const Document& document);

}  // namespace fca::text
