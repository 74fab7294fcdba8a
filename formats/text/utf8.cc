// SPDX-License-Identifier: BSD-3-Clause
#include "utf8.h"

namespace fca::text {

void append_utf8(std::uint32_t code, std::string& text) {
  const auto append = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto follow = [&append, code](unsigned shift) { append(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) return append(code);
  if (code < 0x800) {
    append(0xC0U | (code >> 6U));
  } else if (code < 0x10000) {
    append(0xE0U | (code >> 12U));
    follow(6);
  } else {
    append(0xF0U | (code >> 18U));
    follow(12);
    follow(6);
  }
  follow(0);
}

}  // namespace fca::text
