// SPDX-License-Identifier: BSD-3-Clause
#include "preview_text.h"

#include "commands/convert/convert_command.h"
#include "shell/option_hints.h"
#include "shell/verdict_text.h"
#include "shell/words.h"

#include <fca/formats/wording.h>

#include <algorithm>

namespace fca::cli {

std::string preview_text(const ConvertResult& outcome) {
  const auto& entries = outcome.diagnostics.entries();
  const auto error = std::ranges::find(entries, Severity::kError, &Diagnostic::severity);
  if (error != entries.end()) {
    const std::string fix = fix_of(*error, with_options);
    return paragraph("convert would not write it: " + message_of(*error, with_options) + (fix.empty() ? "" : " (" + fix + ")"),
                     "  ");
  }
  const bool rewrite = outcome.from == outcome.to;
  const std::string how = rewrite ? "converted (--to " + std::string(outcome.to->id) + " --rewrite): " : "converted: ";
  return paragraph(how + std::string(in_words(outcome.verdict.word)) + "; " + text::text_of(outcome.headline, with_options),
                   "  ") +
         summary_lines(outcome, false);
}

}  // namespace fca::cli
