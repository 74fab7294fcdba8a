// SPDX-License-Identifier: BSD-3-Clause
// What a message of the toolkit speaks of, as values: its sentence may change.
#pragma once

#include <fca/message.h>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace fca::test {

/// The argument at that place; throws where it is missing or of another kind, which fails the test.
template <class T>
const T& argument(const Message& message, std::size_t place) {
  return std::get<T>(message.arguments.at(place).value);
}

/// The messages inside a message.
inline const std::vector<Message>& clauses(const Message& message, std::size_t place) {
  return argument<std::vector<Message>>(message, place);
}

}  // namespace fca::test
