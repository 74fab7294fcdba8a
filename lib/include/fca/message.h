// SPDX-License-Identifier: BSD-3-Clause
// A message is a fact until somebody words it: a code and what it speaks of. The sentences of the codes stand in one table
// (lib/diagnostics); fca/formats/text/message.h renders them.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fca {

enum class Code : std::uint16_t;  // fca/code.h
struct Message;

/// A number that counts things, and not a truth value.
template <class T>
concept Count = std::integral<T> && !std::same_as<T, bool>;

/// What a message speaks of: a name, a number, names, or clauses (messages inside a message; none: the clause is left out).
struct Argument {
  using Value = std::variant<std::string, double, std::int64_t, std::vector<std::string>, std::vector<Message>>;

  // NOLINTBEGIN(google-explicit-constructor): {camera.name, 0.5, 3} is a list of arguments.
  Argument(std::string text);
  Argument(std::string_view text);
  Argument(const char* text);
  Argument(double number);
  template <Count T>
  Argument(T count);
  Argument(std::vector<std::string> names);
  Argument(Message clause);
  Argument(std::vector<Message> clauses);
  // NOLINTEND(google-explicit-constructor)

  Value value;
};

/// A sentence of the table by its code, and what it is about. Message{} says nothing.
struct Message {
  Code code{};
  std::vector<Argument> arguments = {};

  [[nodiscard]] bool is_said() const { return code != Code{}; }
};

inline Argument::Argument(std::string text) : value(std::move(text)) {}
inline Argument::Argument(std::string_view text) : value(std::string(text)) {}
inline Argument::Argument(const char* text) : value(std::string(text)) {}
inline Argument::Argument(double number) : value(number) {}
template <Count T>
Argument::Argument(T count) : value(static_cast<std::int64_t>(count)) {}
inline Argument::Argument(std::vector<std::string> names) : value(std::move(names)) {}
inline Argument::Argument(Message clause) : value(std::vector<Message>{std::move(clause)}) {}
inline Argument::Argument(std::vector<Message> clauses) : value(std::move(clauses)) {}

[[nodiscard]] bool operator==(const Argument& a, const Argument& b);
[[nodiscard]] inline bool operator==(const Message& a, const Message& b) {
  return a.code == b.code && a.arguments == b.arguments;
}
[[nodiscard]] inline bool operator==(const Argument& a, const Argument& b) { return a.value == b.value; }

}  // namespace fca
