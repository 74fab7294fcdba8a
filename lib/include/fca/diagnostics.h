// SPDX-License-Identifier: BSD-3-Clause
// What is wrong, where, and how to mend it. Library functions report here; they never print, exit or abort.
#pragma once

#include <cstddef>
#include <string>
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

/// One finding, in words for the person who owns the file.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string code;     ///< Stable, kebab-case: "missing-key", "not-a-rotation".
  std::string message;  ///< What is wrong, one sentence.
  std::string fix;      ///< How to mend it; may be empty.
  SourceRange where;
};

/// Collects every problem of a run; warnings may stand beside a success.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { entries_.push_back(std::move(diagnostic)); }
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
