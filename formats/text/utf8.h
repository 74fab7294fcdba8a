// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace fca::text {

/// A character of Unicode by its code point, at most 0x10FFFF.
void append_utf8(std::uint32_t code, std::string& text);

}  // namespace fca::text
