// SPDX-License-Identifier: BSD-3-Clause
// Parses the words with which a user accepts reasons against a file.
#pragma once

#include <fca/formats/verdict_value.h>

#include <optional>
#include <string>
#include <string_view>

namespace fca {

/// The result of parse_acceptance().
struct TypedAcceptance {
  std::string id;                             ///< The id that the user typed.
  std::optional<Acceptance> acceptance = {};  ///< nullopt if no code has that id.
};

/// Parses "CODE" or "CODE:CAMERA".
[[nodiscard]] TypedAcceptance parse_acceptance(std::string_view word);

}  // namespace fca
