// SPDX-License-Identifier: BSD-3-Clause
// Functions with many keywords: a table says what each means for a request.
#pragma once

#include "bindings.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace fca::python {

/// What a keyword was given.
class Value {
 public:
  Value(std::string name, py::handle given) : name_(std::move(name)), given_(given) {}

  /// Raises TypeError where it is of another type.
  template <class Type>
  [[nodiscard]] Type as() const {
    try {
      return given_.cast<Type>();
    } catch (const py::cast_error&) {
      throw py::type_error(name_ + " is no " + std::string(py::str(py::type::handle_of(given_).attr("__name__"))));
    }
  }
  [[nodiscard]] py::handle given() const { return given_; }
  /// Raises ValueError.
  [[noreturn]] void refuse(const std::string& wanted) const { raise_value_error(name_ + " is " + wanted); }

 private:
  std::string name_;
  py::handle given_;
};

template <class Request>
struct Keyword {
  const char* name;
  void (*take)(const Value& value, Request& request);
};

/// In the order of the table. None is as if nothing was given. Raises TypeError of a keyword that is not there.
template <class Request, std::size_t kCount>
void take_keywords(const std::array<Keyword<Request>, kCount>& known, const py::kwargs& given, Request& request) {
  for (const auto& each : given) {
    const auto name = each.first.cast<std::string>();
    if (std::ranges::none_of(known, [&name](const Keyword<Request>& keyword) { return name == keyword.name; }))
      throw py::type_error("unexpected keyword argument '" + name + "'");
  }
  for (const Keyword<Request>& keyword : known) {
    if (!given.contains(keyword.name)) continue;
    const py::object value = given[keyword.name];
    if (!value.is_none()) keyword.take(Value(keyword.name, value), request);
  }
}

}  // namespace fca::python
