// SPDX-License-Identifier: BSD-3-Clause
// What is wrong, where, and how to fix it. Library functions report here; they never print, exit or abort.
#pragma once

#include <fca/message.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fca {

enum class Severity { kNote, kWarning, kError };

/// "note", "warning", "error"
[[nodiscard]] std::string_view name_of(Severity severity);

/// Bytes [offset, offset + length) of the file `file`. An empty `file` means: no place.
struct SourceRange {
  std::string file;
  std::size_t offset = 0;
  std::size_t length = 0;
  bool operator==(const SourceRange&) const = default;
};

/// One finding.
struct Diagnostic {
  Severity severity = Severity::kError;
  Message facts;  ///< What is wrong.
  SourceRange where = {};
  Message remedy = {};  ///< How to fix it, where the caller knows better than the table: that code's `fix`, else its `text`.
  Code kind = {};       ///< Whose id it has, where that is not the sentence's: that of the error that this one wraps.
};

/// The public name of what is said, kebab-case: "missing-key", "not-a-rotation".
[[nodiscard]] std::string id_of(const Message& message);
[[nodiscard]] std::string id_of(const Diagnostic& diagnostic);
/// Whose id it has.
[[nodiscard]] Code code_of(const Diagnostic& diagnostic);
/// Have both the same id, as sentences about one defect have? Code::kAny... stands for all of an id.
[[nodiscard]] bool same_id(Code a, Code b);
[[nodiscard]] bool same_id(Code code, std::span<const Code> any);

/// Collects every problem of a run; warnings may stand next to a success.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { entries_.push_back(std::move(diagnostic)); }
  /// As severe as the table says.
  void add(Code code, std::vector<Argument> arguments = {}, SourceRange where = {});
  void add(Severity severity, Code code, std::vector<Argument> arguments = {}, SourceRange where = {});
  void add(Message facts, SourceRange where = {}) { add(facts.code, std::move(facts.arguments), std::move(where)); }
  [[nodiscard]] const std::vector<Diagnostic>& entries() const { return entries_; }
  [[nodiscard]] bool has_errors() const {
    for (const Diagnostic& entry : entries_) {
      if (entry.severity == Severity::kError) return true;
    }
    return false;
  }

 private:
  std::vector<Diagnostic> entries_;
};

}  // namespace fca
