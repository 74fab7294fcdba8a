// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/source.h>

#include <algorithm>

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

std::string valid_utf8(std::string_view bytes) {
  std::string text(bytes);
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = byte < 0x80 ? 1 : (byte >> 5) == 0x6 ? 2 : (byte >> 4) == 0xE ? 3 : (byte >> 3) == 0x1E ? 4 : 0;
    bool good = length > 0 && i + length <= text.size();
    for (std::size_t k = 1; good && k < length; ++k) good = (static_cast<unsigned char>(text[i + k]) & 0xC0u) == 0x80u;
    if (!good) text[i] = '?';
    i += good ? length : 1;
  }
  return text;
}

}  // namespace fca::text
