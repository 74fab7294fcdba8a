// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fca::text {

/// Text with blanks inserted, and the way back to the original's offsets.
struct SpacedText {
  std::string text;
  std::vector<std::size_t> insertions;  ///< Offsets in `text` of the inserted blanks, ascending.

  /// The offset in the original of an offset in `text`.
  [[nodiscard]] std::size_t original_offset(std::size_t offset) const;
};

/// cv::FileStorage reads `key:value`; YAML demands `key: value`. Inserts the missing blank after the colon of block keys, and
/// nowhere else: not inside quotes, comments or flow collections.
[[nodiscard]] SpacedText space_after_keys(std::string_view bytes);

}  // namespace fca::text
