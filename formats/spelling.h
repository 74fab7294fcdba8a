// SPDX-License-Identifier: BSD-3-Clause
// How fields look in each syntax. YAML is how their tokens are given; the others are made from it.
#pragma once

#include "fields.h"

namespace fca::fields {

/// How a value of several lines is laid out.
struct Style {
  bool one_line = false;        ///< As inside a flow collection on one line.
  std::size_t indentation = 0;  ///< Of a matrix's own keys, in blanks; 0: what the syntax's program writes.
};

/// The token of a scalar as the syntax has it: JSON quotes every text, XML has entities.
[[nodiscard]] std::string spell_token(const std::string& token, text::Syntax syntax);

/// A field's value. YAML: what stands after "key:", with its blank or line break. JSON: what stands after "key": without. XML
/// has no value without its element.
[[nodiscard]] std::string spell_value(const Field& field, text::Syntax syntax, const Style& style);

/// The key with the value; lines but the first are indented relative to it. No last line break.
[[nodiscard]] std::string spell_entry(const Field& field, text::Syntax syntax, const Style& style);

/// Does the scalar already say what the token says? Numbers by value, anything else by its text.
[[nodiscard]] bool says(const text::Node& node, const std::string& token, text::Syntax syntax);

}  // namespace fca::fields
