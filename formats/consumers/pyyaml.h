// SPDX-License-Identifier: BSD-3-Clause
// Private: a YAML text as yaml.safe_load of PyYAML (YAML 1.1) hands it to a Python program.
//
// yaml-cpp does the syntax; where it is more lenient than PyYAML (TABs, `%YAML:1.0`, several documents, unknown tags, control
// characters) this reader refuses, and the types of the scalars are PyYAML's: `1e-5` is a string, `017` is 15.
#pragma once

#include "fca/message.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fca::consumers::pyyaml {

enum class Kind { kNull, kBool, kInt, kFloat, kString, kList, kMap };

struct Value;
using ValuePtr = std::shared_ptr<const Value>;

struct Value {
  Kind kind = Kind::kNull;
  std::string text;                                    ///< Scalars: as written, without quotes.
  double number = 0.0;                                 ///< Bool, int and float.
  std::vector<ValuePtr> items;                         ///< Lists.
  std::vector<std::pair<ValuePtr, ValuePtr>> entries;  ///< Maps: each key once, with the last of its values, as a dict has it.

  [[nodiscard]] bool is_number() const { return kind == Kind::kBool || kind == Kind::kInt || kind == Kind::kFloat; }
  /// What Python's isinstance(value, int) says; a bool is an int there.
  [[nodiscard]] bool is_int() const { return kind == Kind::kBool || kind == Kind::kInt; }
  /// The value of a string key of a map, or null.
  [[nodiscard]] const Value* find(std::string_view key) const;
};

struct Loaded {
  ValuePtr root;  ///< Null if refused; an empty text is a Value of kind kNull.
  Message error;  ///< Why PyYAML raises, a clause; says nothing if it does not.
};

[[nodiscard]] Loaded safe_load(std::string_view text);

/// Kind and number of a plain scalar (exposed for the tests of the typing rules).
[[nodiscard]] Value resolve_plain_scalar(std::string_view text);

/// "the string '1e-5'", "the int 190", "a list of 3": a clause for sentences.
[[nodiscard]] Message describe(const Value& value);

}  // namespace fca::consumers::pyyaml
