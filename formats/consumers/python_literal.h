// SPDX-License-Identifier: BSD-3-Clause
// Private: a text as Python's ast.literal_eval reads it (CPython 3.11), as far as files specify numbers, texts, lists and
// dicts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fca::consumers::python {

enum class Kind { kNone, kBool, kInt, kFloat, kString, kBytes, kList, kDict };

struct Entry;

struct Value {
  Kind kind = Kind::kNone;
  std::string text;            ///< Texts with their escapes resolved but for \N; bytes as written.
  double number = 0.0;         ///< Bool, int and float.
  std::vector<Value> items;    ///< Lists and tuples.
  std::vector<Entry> entries;  ///< Dicts: of keys that are texts, in the order of the file.

  /// What isinstance(value, numbers.Number) says; a bool is one.
  [[nodiscard]] bool is_number() const { return kind == Kind::kBool || kind == Kind::kInt || kind == Kind::kFloat; }
  [[nodiscard]] bool is_int() const { return kind == Kind::kBool || kind == Kind::kInt; }
  /// The last value of a key of a dict, or null.
  [[nodiscard]] const Value* find(std::string_view key) const;
};

struct Entry {
  std::string key;
  Value value;
};

struct Loaded {
  Value root;
  std::string error;  ///< Why it raises ("SyntaxError in line 3"); empty if it does not.
};

[[nodiscard]] Loaded literal_eval(std::string_view text);

}  // namespace fca::consumers::python
