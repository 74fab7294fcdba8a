// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/source.h>

#include "npy.h"

#include <algorithm>
#include <array>

namespace fca::text {

Position Source::position(std::size_t offset) const {
  offset = std::min(offset, bytes.size());
  const std::size_t start = line_at(offset).offset;
  Position position;
  position.line = 1 + static_cast<int>(std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(start), '\n'));
  for (std::size_t i = start; i < offset; ++i) {
    const bool continuation = (static_cast<unsigned char>(bytes[i]) & 0xC0u) == 0x80u;
    if (!continuation) ++position.column;
  }
  return position;
}

bool Source::is_binary() const {
  if (begins_as_npy(bytes)) return true;
  constexpr std::size_t kOfCount = 8;
  constexpr std::size_t kSmallest = 8;  // a rig without sensors
  if (name.ends_with(".bin") && (bytes.size() < kOfCount || bytes.find('\0') != std::string::npos)) return true;
  if (bytes.size() < 2 * kOfCount || bytes.compare(4, 4, std::string(4, '\0')) != 0) return false;
  std::size_t count = 0;
  for (std::size_t i = 4; i-- > 0;) count = count * 256 + static_cast<unsigned char>(bytes[i]);
  return count <= bytes.size() / kSmallest;
}

Span Source::line_at(std::size_t offset) const {
  offset = std::min(offset, bytes.size());
  const std::size_t newline = offset == 0 ? std::string::npos : bytes.rfind('\n', offset - 1);
  const std::size_t start = newline == std::string::npos ? byte_order_mark() : newline + 1;
  std::size_t end = std::min(bytes.find('\n', std::max(offset, start)), bytes.size());
  if (end > start && bytes[end - 1] == '\r') --end;
  return {start, end - start};
}

std::string_view Source::line_break() const {
  const std::size_t newline = bytes.find('\n');
  return newline != std::string::npos && newline > 0 && bytes[newline - 1] == '\r' ? "\r\n" : "\n";
}

namespace {

/// Length of the UTF-8 character at `at`; 0 if the bytes there are none (RFC 3629: no overlong forms, no surrogates, none
/// beyond U+10FFFF).
std::size_t character_length(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u;
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return continues(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const bool overlong = lead == 0xE0 && byte(1) < 0xA0;
    const bool surrogate = lead == 0xED && byte(1) > 0x9F;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const bool overlong = lead == 0xF0 && byte(1) < 0x90;
    const bool too_large = lead == 0xF4 && byte(1) > 0x8F;
    return continues(1) && continues(2) && continues(3) && !overlong && !too_large ? 4 : 0;
  }
  return 0;
}

}  // namespace

std::string valid_utf8(std::string_view bytes) {
  std::string text(bytes);
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    if (length == 0) text[i] = '?';
    i += std::max<std::size_t>(1, length);
  }
  return text;
}

std::string printable(std::string_view bytes, bool keep_line_breaks) {
  std::string text = valid_utf8(bytes);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool line_break = byte == '\n' && keep_line_breaks;
    if ((byte < 0x20 && !line_break) || byte == 0x7F) text[i] = ' ';
    // U+0080 .. U+009F are control characters, too: U+009B opens an escape sequence.
    const bool c1 = byte == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (c1) text.replace(i, 2, "?");
    // U+2028 and U+2029 end a line, and with it a comment, to PyYAML; U+FFFE and U+FFFF are no characters to it and to XML.
    constexpr std::array<std::string_view, 4> kNotInALine = {"\xE2\x80\xA8", "\xE2\x80\xA9", "\xEF\xBF\xBE", "\xEF\xBF\xBF"};
    const std::string_view rest = std::string_view(text).substr(i);
    if (std::ranges::any_of(kNotInALine, [rest](std::string_view each) { return rest.starts_with(each); }))
      text.replace(i, 3, "?");
  }
  return text;
}

}  // namespace fca::text
