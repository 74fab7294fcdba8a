// SPDX-License-Identifier: BSD-3-Clause
// Reasons against a file that a user overrules, as people type them.
#pragma once

#include <fca/formats/verdict_value.h>

#include <optional>
#include <string>
#include <string_view>

namespace fca {

/// A code that was typed and, where the table has it, what it accepts.
struct TypedAcceptance {
  std::string id;
  std::optional<Acceptance> acceptance = {};  ///< Nothing: no code has that id.
};

/// "CODE" or "CODE:CAMERA".
[[nodiscard]] TypedAcceptance parse_acceptance(std::string_view word);

}  // namespace fca
