// SPDX-License-Identifier: BSD-3-Clause
#include "batch_report.h"

#include "convert_command.h"
#include "shell/words.h"

#include <fca/code.h>

#include <algorithm>

namespace fca::cli {

namespace {

/// The summary says the others.
Diagnostics without_errors(const Diagnostics& diagnostics) {
  Diagnostics rest;
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity != Severity::kError) rest.add(entry);
  }
  return rest;
}

}  // namespace

BatchReport::BatchReport(Batch& batch, const ConvertArguments& arguments, const Console& console)
    : batch_(batch), arguments_(arguments), console_(console), table_(batch.spool()) {}

void BatchReport::add(const Finished& finished, bool is_reached) {
  if (arguments_.json_lines) {
    if (is_reached) console_.out(conversion_line(finished.json));
  } else if (arguments_.json) {
    console_.out(json_.next(finished.json, batch_.converted()));
  } else if (is_reached) {
    print(finished);
  }
  TableRow row = finished.row;
  if (!is_reached) row.result = "not written";
  table_.add(row);
  has_result_ = has_result_ || finished.has_result();
  if (finished.is_evaluated) words_.add(finished.word);
  const bool is_good = finished.code == ExitCode::kGood;
  const auto is_file = [](const OutputFile& file) { return !file.path.empty(); };
  if (is_good) ++good_;
  if (is_good && is_reached) files_ += static_cast<std::size_t>(std::ranges::count_if(finished.files, is_file));
  if (is_reached) code_ = worse(code_, finished.code);
  if (!is_reached) ++not_reached_;
}

void BatchReport::print(const Finished& finished) const {
  const bool is_written = !arguments_.dry_run;
  // That a file is not to be used is an error, also for those who want to see errors only.
  const bool is_wanted = !arguments_.quiet || finished.code != ExitCode::kGood;
  const bool has_word = !finished.files.empty() || finished.word == VerdictWord::kDoNotUse;
  const bool has_summary = finished.has_result() && finished.whole && is_wanted && has_word;
  if (has_summary) {
    std::string report = convert_summary(*finished.whole, is_written, arguments_.verbosity == 0);
    if (arguments_.verbosity > 0) report += "\n" + convert_text(*finished.whole, is_written, arguments_.verbosity > 1);
    const bool is_file_on_stdout = arguments_.output.is_standard_output() && !arguments_.in_place && is_written;
    is_file_on_stdout || arguments_.quiet ? console_.print_stderr(report, finished.word) : console_.say(report, finished.word);
  }
  if (finished.whole && !arguments_.quiet && (arguments_.verbosity > 0 || !finished.has_result())) {
    const Diagnostics& diagnostics = finished.whole->diagnostics;
    console_.show(has_summary ? without_errors(diagnostics) : diagnostics);
  } else if (!has_summary) {
    console_.err(finished.errors);
  }
}

void BatchReport::end() {
  if (arguments_.json && !arguments_.json_lines) console_.out(json_.end(batch_.converted()));
  if (!arguments_.json) warn_of_unused();
  const bool are_several = batch_.converted() != 1 || batch_.skipped() > 0 || batch_.left() > 0;
  if (!are_several || arguments_.quiet) return;
  const auto say = [this](std::string_view text) { arguments_.json ? console_.print_stderr(text) : console_.say(text); };
  say("\n");
  table_.print(say);
  say("\n" + last_line());
}

/// What was accepted for nothing, of any input, is a mistake, or a leftover.
void BatchReport::warn_of_unused() const {
  for (std::size_t i = 0; i < arguments_.request.accepted.size(); ++i) {
    const Acceptance& accepted = arguments_.request.accepted[i];
    if (!has_result_ || batch_.used_acceptances()[i]) continue;
    console_.err("warning: --accept " + std::string(info(accepted.code).id) +
                 (accepted.camera.empty() ? "" : ":" + accepted.camera) + " was not needed\n");
  }
}

std::string BatchReport::last_line() const {
  const bool is_interrupted = not_reached_ > 0 || batch_.left() > 0;
  std::string text = (is_interrupted ? "interrupted: " : "") + std::to_string(good_) + " of " +
                     counted(batch_.converted() + batch_.left(), "input") + " converted";
  text += arguments_.dry_run ? ", nothing written (--dry-run)" : ", " + counted(files_, "file") + " written";
  const std::size_t skipped = batch_.skipped();
  if (skipped > 0) text += "; " + counted(skipped, "other file") + (skipped == 1 ? " holds" : " hold") + " no camera";
  return text + "; " + words_.in_words() + "\n";
}

}  // namespace fca::cli
