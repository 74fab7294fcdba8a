// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"
#include "outcome.h"
#include "shell/console.h"

#include <string>
#include <vector>

namespace fca::cli {

/// Adds `convert` to the application.
void add_convert_command(Application& application);

/// "kb4 -> eucm, fitted"
[[nodiscard]] std::string camera_line(const ConvertedCamera& camera);
/// How a real program reads the written files.
struct ProofWords {
  std::string verdict;               ///< "Kalibr loads it; ..."
  std::vector<std::string> details;  ///< What belongs to it, a line each.
};
[[nodiscard]] std::vector<ProofWords> proofs_in_words(const ConvertResult& result);
/// The verdict and what a user must act on, in some ten lines (summary.cc). `with_tables`: and the errors over the angle of
/// fits that are far off.
[[nodiscard]] std::string convert_summary(const ConvertOutcome& outcome, bool written, bool with_tables);
/// The same without its first line, and no tables: "-v" has them.
[[nodiscard]] std::string summary_lines(const ConvertResult& outcome, bool with_tables);
/// The full report for people (convert_text.cc) and for scripts (convert_json.cc).
[[nodiscard]] std::string convert_text(const ConvertOutcome& outcome, bool written);
[[nodiscard]] std::string convert_json(const std::vector<ConvertOutcome>& outcomes, const Console& console);

}  // namespace fca::cli
