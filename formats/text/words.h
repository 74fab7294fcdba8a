// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>

#include <optional>

namespace fca::text {

/// The tag of a line whose first character that is no blank is '#'.
inline constexpr std::string_view kCommentTag = "comment";

/// Splits text into lines and words (OCamCalib's calib_results.txt, DSO's camera.txt). The root is a sequence with one item for
/// every physical line, blank ones included; each is a sequence of words, with the tag kCommentTag if it begins with '#'. Lines
/// span from their first to their last word; blank ones are empty sequences at the line's beginning.
[[nodiscard]] std::optional<Node> parse_words(const Source& source, Diagnostics& diagnostics);

}  // namespace fca::text
