// SPDX-License-Identifier: BSD-3-Clause
// An input that was converted: what is left to be written and to be reported.
#pragma once

#include "batch_table.h"
#include "outcome.h"
#include "shell/console.h"
#include "toolkit/save/output_file.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

struct Finished {
  std::string input;
  ExitCode code = ExitCode::kGood;
  bool is_evaluated = false;  ///< The verdict says something.
  VerdictWord word = VerdictWord::kReady;
  bool has_error = false;         ///< Among its diagnostics.
  std::vector<OutputFile> files;  ///< Those without a path go to standard output. No bytes: not to be written.
  TableRow row;
  std::string errors;                   ///< As they are printed.
  std::string json;                     ///< Its object; empty: not asked for.
  std::optional<ConvertOutcome> whole;  ///< For a report. It is not packed.

  /// Has it a result to report?
  [[nodiscard]] bool has_result() const { return is_evaluated && code != ExitCode::kIo; }
  /// It could not be written.
  void fail(const Message& problem, const Console& console);
};

/// `sources`: what its diagnostics point into.
[[nodiscard]] Finished finished(const ConvertOutcome& outcome, const ConvertArguments& arguments,
                                std::span<const text::Source> sources, const Console& console);

/// For a spool, and back.
[[nodiscard]] std::string packed(const Finished& finished);
[[nodiscard]] Finished unpacked(std::string_view bytes);

}  // namespace fca::cli
