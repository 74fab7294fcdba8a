// SPDX-License-Identifier: BSD-3-Clause
// The bytes of a file, and places in them.
#pragma once

#include <fca/diagnostics.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace fca::text {

/// Files above this are no calibration (the largest real one seen has 193 kB) and would cost seconds to parse.
inline constexpr std::size_t kMaxFileBytes = 2u * 1024u * 1024u;

/// Bytes [offset, offset + length) of a Source.
struct Span {
  std::size_t offset = 0;
  std::size_t length = 0;
  [[nodiscard]] std::size_t end() const { return offset + length; }
  bool operator==(const Span&) const = default;
};

/// A line and column as people count: from 1, columns in characters (UTF-8 code points).
struct Position {
  int line = 1;
  int column = 1;
};

/// A file's name and its bytes, exactly as they were.
struct Source {
  std::string name;
  std::string bytes;

  [[nodiscard]] std::string_view text(const Span& span) const {
    return std::string_view(bytes).substr(span.offset, span.length);
  }
  [[nodiscard]] SourceRange range(const Span& span) const { return {name, span.offset, span.length}; }
  [[nodiscard]] Position position(std::size_t offset) const;
  /// The line that holds `offset`, without its line break.
  [[nodiscard]] Span line_at(std::size_t offset) const;
  /// Is it no text but one of COLMAP's binary files? Named ".bin" and with a zero byte (or cut off in the first number), or by
  /// any name one that begins with a small number of 8 bytes, the lowest first. Its places are told by their offset.
  [[nodiscard]] bool is_binary() const;
  /// Length of a UTF-8 byte order mark at the start: 0 or 3.
  [[nodiscard]] std::size_t byte_order_mark() const { return bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0; }
  /// "\r\n" if the first line ends so, else "\n".
  [[nodiscard]] std::string_view line_break() const;
};

/// The same length, with one '?' for each byte that is not valid UTF-8.
[[nodiscard]] std::string valid_utf8(std::string_view bytes);
/// For a terminal: valid UTF-8 without control characters, so that a file's text cannot drive it.
[[nodiscard]] std::string printable(std::string_view bytes, bool keep_line_breaks = false);

}  // namespace fca::text
