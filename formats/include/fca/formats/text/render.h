// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/source.h>

#include <span>
#include <string>

namespace fca::text {

/// What is to be shown, in words.
struct Shown {
  Severity severity = Severity::kError;
  std::string id = {};  ///< May be empty.
  std::string message = {};
  std::string fix = {};  ///< May be empty.
  SourceRange where = {};
};

/// `file:line:column: error: message [code]`, the line with a caret, and the fix. Without a place: `error: message [code]`.
/// `sources`: the files the diagnostic may point into. `colour`: with terminal escapes.
[[nodiscard]] std::string render(const Shown& shown, std::span<const Source> sources, bool colour = false);
/// `wording`: where the sentences of codes come from.
[[nodiscard]] std::string render(const Diagnostic& diagnostic, std::span<const Source> sources, bool colour = false,
                                 Wording wording = table_wording);

}  // namespace fca::text
