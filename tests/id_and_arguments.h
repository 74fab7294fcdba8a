// SPDX-License-Identifier: BSD-3-Clause
// Messages as facts: their ids and what they speak of, without the words of the table.
#pragma once

#include <fca/diagnostics.h>
#include <fca/message.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fca::test {

/// As it is; in quotes where it would be taken for more words, for a number or for a list.
inline std::string in_quotes_if_needed(std::string_view text) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("_.,:/*-%!'").find(c) != std::string_view::npos;
  };
  const auto of_a_name = [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '%' || c == '/';
  };
  if (!text.empty() && of_a_name(text.front()) && std::ranges::all_of(text, plain)) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    char escaped[8] = {c, '\0'};
    if (c == '"' || c == '\\') std::snprintf(escaped, sizeof(escaped), "\\%c", c);
    if (static_cast<unsigned char>(c) < 0x20 || c == '\x7f') std::snprintf(escaped, sizeof(escaped), "\\x%02X", c);
    quoted += escaped;
  }
  return quoted + "\"";
}

/// "out-of-range cam0 T_cam_imu 1e+308 1000000": the id and the arguments. Real numbers have 6 digits, so that compilers agree;
/// names stand in [], messages in a message in (), with ';' between them.
inline std::string id_and_arguments(const Message& message) {
  struct Writer {
    std::string operator()(const std::string& text) const { return in_quotes_if_needed(text); }
    std::string operator()(double number) const {
      char digits[32];
      std::snprintf(digits, sizeof(digits), "%.6g", number);
      return digits;
    }
    std::string operator()(std::int64_t count) const { return std::to_string(count); }
    std::string operator()(const std::vector<std::string>& names) const {
      std::string list;
      for (const std::string& name : names) list += (list.empty() ? "" : " ") + in_quotes_if_needed(name);
      return "[" + list + "]";
    }
    std::string operator()(const std::vector<Message>& clauses) const {
      std::string list;
      for (const Message& clause : clauses) list += (list.empty() ? "" : "; ") + id_and_arguments(clause);
      return "(" + list + ")";
    }
  };
  std::string text = id_of(message);
  for (const Argument& argument : message.arguments) text += " " + std::visit(Writer{}, argument.value);
  return text;
}

/// Is the value an argument of the message, or of a message in it? Real numbers are compared to 6 digits.
inline bool speaks_of(const Message& message, const Argument& value) {
  return std::ranges::any_of(message.arguments, [&value](const Argument& argument) {
    const auto* number = std::get_if<double>(&argument.value);
    const auto* wanted = std::get_if<double>(&value.value);
    if (number != nullptr && wanted != nullptr && std::abs(*number - *wanted) <= 1e-6 * std::abs(*wanted)) return true;
    if (argument == value) return true;
    const auto* names = std::get_if<std::vector<std::string>>(&argument.value);
    const auto* name = std::get_if<std::string>(&value.value);
    if (names != nullptr && name != nullptr && std::ranges::find(*names, *name) != names->end()) return true;
    const auto* clauses = std::get_if<std::vector<Message>>(&argument.value);
    if (clauses == nullptr) return false;
    const auto* wanted_clauses = std::get_if<std::vector<Message>>(&value.value);
    return std::ranges::any_of(*clauses, [&](const Message& clause) {
      const bool is_it = wanted_clauses != nullptr && wanted_clauses->size() == 1 && clause == wanted_clauses->front();
      return is_it || speaks_of(clause, value);
    });
  });
}

/// Is it said with that code, and of all these values?
inline bool is_said_of(const Message& message, Code code, const std::vector<Argument>& values) {
  return message.code == code &&
         std::ranges::all_of(values, [&message](const Argument& value) { return speaks_of(message, value); });
}

}  // namespace fca::test
