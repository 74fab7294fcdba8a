// SPDX-License-Identifier: BSD-3-Clause
// What is wrong, where, and how to mend it. Library functions report here; they never print, exit or abort.
#pragma once

#include <fca/message.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fca {

enum class Severity { kNote, kWarning, kError };

/// Bytes [offset, offset + length) of the file `file`. An empty `file` means: no place.
struct SourceRange {
  std::string file;
  std::size_t offset = 0;
  std::size_t length = 0;
};

/// One finding. Of those whose writers still word them themselves, the words stand in `code`, `message` and `fix`; a word that
/// stands there is said in place of the table's. Readers ask id_of(), and message_of() and fix_of() of the formats' text layer.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string code;     ///< Stable, kebab-case: "missing-key", "not-a-rotation".
  std::string message;  ///< What is wrong, one sentence.
  std::string fix;      ///< How to mend it; may be empty.
  SourceRange where;
  Message facts = {};
};

/// The public name of what is said, kebab-case: "missing-key", "not-a-rotation".
[[nodiscard]] std::string id_of(const Message& message);
[[nodiscard]] std::string id_of(const Diagnostic& diagnostic);

/// Collects every problem of a run; warnings may stand beside a success.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { entries_.push_back(std::move(diagnostic)); }
  /// As severe as the table says.
  void add(Code code, std::vector<Argument> arguments = {}, SourceRange where = {});
  void add(Severity severity, Code code, std::vector<Argument> arguments = {}, SourceRange where = {});
  void error(std::string code, std::string message, SourceRange where = {}, std::string fix = {}) {
    add({Severity::kError, std::move(code), std::move(message), std::move(fix), std::move(where)});
  }
  void warning(std::string code, std::string message, SourceRange where = {}, std::string fix = {}) {
    add({Severity::kWarning, std::move(code), std::move(message), std::move(fix), std::move(where)});
  }
  void note(std::string code, std::string message, SourceRange where = {}, std::string fix = {}) {
    add({Severity::kNote, std::move(code), std::move(message), std::move(fix), std::move(where)});
  }

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
