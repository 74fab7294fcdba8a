// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refusal.h"

#include <optional>
#include <string>
#include <string_view>

namespace fca::text {

/// A string of Python.
struct PythonString {
  std::string value;      ///< With its escapes resolved, as UTF-8; of bytes as it stands between the quotes.
  bool is_bytes = false;  ///< b'..'
  std::size_t end = 0;    ///< The offset after its last quote.
};

/// Does a string stand there: a quote, or one after a prefix (b, r, u and their pairs, in any case)?
[[nodiscard]] bool begins_string(std::string_view text);

/// Reads the string that begins at `start`; why it cannot be read, and where, otherwise.
[[nodiscard]] std::optional<Refusal> read_string(std::string_view bytes, std::size_t start, PythonString& string);

}  // namespace fca::text
