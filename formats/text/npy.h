// SPDX-License-Identifier: BSD-3-Clause
// NumPy's .npy files of versions 1.0 and 2.0 (numpy/lib/format.py): two-dimensional arrays of floating-point numbers, little
// endian, row by row.
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>

#include <optional>
#include <string_view>

namespace fca::text {

/// The tag of such a document's root.
inline constexpr std::string_view kNpyTag = "npy";

/// Does a file with these bytes begin as NumPy's do?
[[nodiscard]] bool begins_as_npy(std::string_view bytes);

/// The root is a sequence of rows with kNpyTag, a row a sequence of numbers; the value of a number is its shortest text that
/// reads back the same.
[[nodiscard]] std::optional<Node> parse_npy(const Source& source, Diagnostics& diagnostics);

}  // namespace fca::text
