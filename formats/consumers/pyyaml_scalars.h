// SPDX-License-Identifier: BSD-3-Clause
// Private: which plain scalars are numbers to PyYAML, and which.
#pragma once

#include <initializer_list>
#include <string_view>

#include "pyyaml.h"

namespace fca::consumers::pyyaml {

[[nodiscard]] bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words);
[[nodiscard]] bool is_digit(char c);
/// Cuts all leading characters of the set off and says how many there were.
std::size_t skip(std::string_view& text, std::string_view set);

/// The four patterns of PyYAML 6, yaml/resolver.py, tag:yaml.org,2002:float.
[[nodiscard]] bool matches_float(std::string_view text);
/// The five patterns of tag:yaml.org,2002:int.
[[nodiscard]] bool matches_int(std::string_view text);
/// Of a text that matches; `kind`: kInt or kFloat.
[[nodiscard]] double parse_number(std::string_view text, Kind kind);

}  // namespace fca::consumers::pyyaml
