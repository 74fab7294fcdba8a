// SPDX-License-Identifier: BSD-3-Clause
// What a run said, as codes and values; its sentences are compared in golden/ alone.
#pragma once

#include "cli/run_program.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <rapidjson/document.h>

namespace fca::test {

/// Is a diagnostic with that code among what was printed? `part`: a value (a name, a number, an option) that it has in its
/// message or its fix.
inline bool says(const std::string& printed, const std::string& code, const std::string& part = {}) {
  std::istringstream stream(printed);
  std::string block;
  bool ours = false;
  // Whatever belongs to a diagnostic is indented under its first line.
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(' ')) {
      if (ours && contains(block, part)) return true;
      block.clear();
      ours = line.ends_with("[" + code + "]");
    }
    block += line + "\n";
  }
  return ours && contains(block, part);
}

/// The whole numbers in the last line, such as those of "3 of 3 inputs converted, 3 files written", but for the counts of
/// verdicts at its end.
inline std::vector<int> numbers_of_last_line(const std::string& text) {
  std::string rest = text.substr(0, text.find_last_not_of('\n') + 1);
  rest = rest.substr(rest.rfind('\n') + 1);
  const std::size_t counts = rest.rfind("; ");
  if (counts != std::string::npos && contains(rest.substr(counts), "do not use")) rest.resize(counts);
  std::vector<int> numbers;
  bool inside = false;
  for (const char c : rest) {
    const bool digit = c >= '0' && c <= '9';
    if (digit && !inside) numbers.push_back(0);
    if (digit) numbers.back() = numbers.back() * 10 + (c - '0');
    inside = digit;
  }
  return numbers;
}

/// A run with --json.
class Told {
 public:
  explicit Told(std::vector<std::string> words, const RunOptions& options = {}) {
    words.emplace_back("--json");
    run_ = run_program(words, options);
    json_.Parse(run_.out.c_str());
    EXPECT_FALSE(json_.HasParseError()) << words.front() << ": " << run_.out << run_.err;
  }

  [[nodiscard]] int code() const { return run_.code; }
  [[nodiscard]] const rapidjson::Document& json() const { return json_; }
  /// The whole of it, for the message of a test that fails.
  [[nodiscard]] std::string text() const { return run_.out + run_.err; }
  /// A diagnostic with that code, and that value in its message or its fix.
  [[nodiscard]] bool says(const std::string& code, const std::string& part = {}) const {
    return any("diagnostics", code, {"message", "fix"}, part);
  }
  /// A loss with that code, and that value in what is lost, why, or what to do.
  [[nodiscard]] bool lost(const std::string& code, const std::string& part = {}) const {
    return any("losses", code, {"what", "why", "do"}, part);
  }
  [[nodiscard]] bool lost_nothing() const { return json_.HasMember("losses") && json_["losses"].Empty(); }
  /// Was the value of that key made up?
  [[nodiscard]] bool made_up(const std::string& key) const {
    return std::ranges::any_of(json_["defaults"].GetArray(), [&key](const auto& each) { return each["key"] == key.c_str(); });
  }
  /// Does a program that reads the file warn of this?
  [[nodiscard]] bool proof_warns(const std::string& part) const {
    return std::ranges::any_of(json_["proof"].GetArray(), [&part](const auto& proof) {
      return std::ranges::any_of(proof["warnings"].GetArray(),
                                 [&part](const auto& warning) { return contains(warning.GetString(), part); });
    });
  }
  /// Does every program that was asked load it?
  [[nodiscard]] bool loads() const {
    const auto proofs = json_["proof"].GetArray();
    return !proofs.Empty() && std::ranges::all_of(proofs, [](const auto& proof) { return proof["loads"].GetBool(); });
  }
  /// What the file written serves, as it says in its first line.
  [[nodiscard]] std::string headline() const { return json_.HasMember("headline") ? json_["headline"].GetString() : ""; }
  /// The bytes of the only output, which goes to standard output.
  [[nodiscard]] std::string bytes() const {
    const auto& outputs = json_["outputs"];
    return outputs.Size() == 1 && outputs[0].HasMember("text") ? outputs[0]["text"].GetString() : "";
  }

 private:
  [[nodiscard]] bool any(const char* list, const std::string& code, const std::vector<const char*>& members,
                         const std::string& part) const {
    if (!json_.IsObject() || !json_.HasMember(list)) return false;
    return std::ranges::any_of(json_[list].GetArray(), [&](const auto& each) {
      return each["code"] == code.c_str() && (part.empty() || std::ranges::any_of(members, [&](const char* member) {
                                                return each.HasMember(member) && contains(each[member].GetString(), part);
                                              }));
    });
  }

  RunResult run_;
  rapidjson::Document json_;
};

}  // namespace fca::test
