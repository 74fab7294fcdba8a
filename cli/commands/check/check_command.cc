// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.h"

#include "shell/calibration_files.h"
#include "shell/option_hints.h"
#include "shell/put_files.h"
#include "shell/words.h"
#include "shell/written_names.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>

#include <algorithm>
#include <filesystem>

namespace fca::cli {

namespace {

/// Makes the certain fixes: shows them, writes them if asked to, and goes on with the fixed text.
ExitCode fix(text::Source& source, const CheckArguments& arguments, Console& console) {
  const std::optional<text::Source> better = with_fixes(arguments.request, source);
  if (!better) return ExitCode::kGood;
  console.say(source.name + ": " + (arguments.write ? "fixed" : "would be fixed (--write does it)") + "\n" +
              line_diff(source.bytes, better->bytes));
  source = *better;
  if (!arguments.write) return ExitCode::kRejected;  // as the file is
  const OutputFile output{source.name, source.bytes};
  remove_leftovers(std::filesystem::path(source.name).parent_path().string());
  const std::optional<Message> problem = put_files(std::span(&output, 1), true, console);
  if (!problem) return ExitCode::kGood;
  console.error(text::text_of(*problem, with_options));
  return ExitCode::kIo;
}

ExitCode code_of(const CheckReport& report, const CheckArguments& arguments) {
  if (!report.is_calibration) return ExitCode::kBadInput;
  const bool bad = report.verdict.word == VerdictWord::kDoNotUse || report.has(Severity::kError) ||
                   (arguments.fail_on_warnings && report.has(Severity::kWarning));
  return bad ? ExitCode::kRejected : ExitCode::kGood;
}

/// The report of a file that could not be opened.
CheckReport unreadable(const Diagnostics& diagnostics) {
  CheckReport report;
  report.is_calibration = false;
  for (const Diagnostic& entry : diagnostics.entries()) {
    report.findings.push_back(
        {.severity = entry.severity, .facts = entry.facts, .where = entry.where, .kind = entry.kind, .remedy = entry.remedy});
    report.verdict.reasons.push_back({.word = VerdictWord::kDoNotUse, .facts = entry.facts, .kind = entry.kind});
  }
  report.verdict.word = VerdictWord::kDoNotUse;
  return report;
}

/// Files that the one at `index` names as parts of it are checked next, each once.
void add_parts(const std::vector<std::string>& parts, std::size_t index, std::vector<FoundFile>& files) {
  for (const std::string& path : parts) {
    const auto same = [&path](const FoundFile& file) {
      return std::filesystem::path(file.path).lexically_normal() == std::filesystem::path(path).lexically_normal();
    };
    if (std::ranges::none_of(files, same)) files.insert(files.begin() + static_cast<std::ptrdiff_t>(++index), {path, true});
  }
}

ExitCode run_check(const CheckArguments& arguments, Console& console) {
  if (arguments.list_codes) {
    for (const CodeInfo& code : check_codes())
      console.say(padded(code.id, 28) + text::text_of({code.code}, with_options) + "\n");
    return ExitCode::kGood;
  }
  if (arguments.explain != nullptr) {
    console.say(explanation(*arguments.explain));
    return ExitCode::kGood;
  }
  if (arguments.files.empty()) return console.refuse(ExitCode::kUsage, "check: FILE is required", "fca-io check --help");
  const bool for_people = !arguments.json && !arguments.sarif;
  ExitCode exit_code = ExitCode::kGood;
  CheckedFiles all;
  bool is_first = true;
  if (const std::optional<std::string> problem = problem_with_patterns(arguments.files))
    return console.refuse(ExitCode::kIo, *problem);
  std::vector<FoundFile> files = walk(arguments.files);
  for (std::size_t i = 0; i < files.size(); ++i) {  // the files that one names are checked after it
    const FoundFile file = files[i];
    Diagnostics diagnostics;
    std::optional<text::Source> source = console.files().read(file.path, diagnostics);
    if (!source) {
      if (!file.named) {
        all.skipped.push_back(file.path);
        continue;
      }
      console.show(diagnostics);
      exit_code = worse(exit_code, ExitCode::kIo);
      all.files.push_back({{file.path, {}}, unreadable(diagnostics), std::nullopt});
      continue;
    }
    if (arguments.fix) exit_code = worse(exit_code, fix(*source, arguments, console));
    CheckResult result = check(arguments.request, *source, console.files());
    if (result.instead) name_as_written(*result.instead);
    if (!file.named && (!result.report.is_calibration || !result.is_opened)) {
      all.skipped.push_back(file.path);
      continue;
    }
    add_parts(result.report.parts, i, files);
    exit_code = worse(exit_code, code_of(result.report, arguments));
    const bool has_nothing = result.report.findings.empty() && result.report.verdict.word == VerdictWord::kReady;
    all.files.push_back(std::move(result));
    if (!for_people || (arguments.quiet && has_nothing)) continue;
    // A file that is no calibration has no result.
    const CheckDetail detail = arguments.quiet     ? CheckDetail::kFindings
                               : arguments.verbose ? CheckDetail::kEverything
                                                   : CheckDetail::kUsual;
    const std::string text = (is_first ? "" : "\n") + check_text(all.files.back(), detail);
    is_first = false;
    all.files.back().report.is_calibration ? console.say(text, all.files.back().report.verdict.word)
                                           : console.print_stderr(text);
  }
  if (all.files.empty()) {
    console.error("no calibration in " + enumerated(arguments.files) + " (" + std::to_string(all.skipped.size()) +
                  " files looked at)");
    exit_code = worse(exit_code, ExitCode::kBadInput);
  }
  if (for_people) {
    const std::string summary = check_summary(all);
    console.say(summary.empty() || is_first ? summary : "\n" + summary);
  }
  if (arguments.json) console.out(check_json(all, console));
  if (arguments.sarif) console.out(check_sarif(all));
  return exit_code;
}

}  // namespace

void add_check_command(Application& application) {
  application.add<CheckArguments>("check", "What is wrong with a file, what happens if it is used, and how to fix it",
                                  &add_check_options, &run_check);
}

}  // namespace fca::cli
