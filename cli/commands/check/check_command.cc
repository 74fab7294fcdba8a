// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.h"

#include "options/inputs.h"
#include "options/output.h"
#include "options/program.h"
#include "options/words.h"
#include "shell/calibration_files.h"
#include "shell/option_hints.h"
#include "shell/put_files.h"
#include "shell/words.h"
#include "shell/written_names.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace fca::cli {

namespace {

std::string no_code(const std::string& word) { return unknown_code(word, "fca-io check --list-codes lists them"); }

/// The row that speaks of a code in general, else its first one.
std::optional<std::string> take_code(const std::string& word, const CodeInfo*& target) {
  target = find_check_code(word) != nullptr ? find_check_code(word) : find_code(word);
  return target != nullptr ? std::nullopt : std::optional(no_code(word));
}

/// What is wrong with the options, in words.
std::optional<std::string> usage_error(const CheckArguments& arguments) {
  const Inputs& inputs = arguments.request.inputs;
  if (const std::optional<std::string> error = problem_with(inputs)) return error;
  std::vector<std::string> changes = given_changes(inputs);
  if (!inputs.parts.empty()) changes.emplace_back("--with");
  if (!changes.empty()) return "check looks at every file as it stands: " + enumerated(changes, "and") + " has no use here";
  if (arguments.write && !arguments.fix) return "--write is for --fix";
  if (arguments.fix && (arguments.json || arguments.sarif))
    return "--fix shows a diff: --json and --sarif have no use beside it";
  if (arguments.fix && arguments.write && std::ranges::find(arguments.files, "-") != arguments.files.end())
    return "--write cannot write to standard input";
  if (arguments.json && arguments.sarif) return "--json and --sarif exclude each other";
  return std::nullopt;
}

/// Makes the certain mends: shows them, writes them if asked to, and goes on with the mended text.
ExitCode fix(text::Source& source, const CheckArguments& arguments, Console& console) {
  const std::optional<text::Source> better = with_fixes(arguments.request, source);
  if (!better) return ExitCode::kGood;
  console.say(source.name + ": " + (arguments.write ? "fixed" : "would be fixed (--write does it)") + "\n" +
              line_diff(source.bytes, better->bytes));
  source = *better;
  if (!arguments.write) return ExitCode::kGood;
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
  return bad ? ExitCode::kJudgedBad : ExitCode::kGood;
}

/// The report of a file that could not be opened.
CheckReport unreadable(const Diagnostics& diagnostics) {
  CheckReport report;
  report.is_calibration = false;
  for (const Diagnostic& entry : diagnostics.entries()) {
    report.findings.push_back(
        {.severity = entry.severity, .facts = entry.facts, .where = entry.where, .kind = entry.kind, .remedy = entry.remedy});
  }
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
  if (const std::optional<std::string> error = usage_error(arguments)) return console.refuse(ExitCode::kUsage, *error);
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
  if (const std::optional<std::string> problem = problem_with_patterns(arguments.files))
    return console.refuse(ExitCode::kIo, *problem);
  std::vector<FoundFile> files = walk(arguments.files);
  for (std::size_t i = 0; i < files.size(); ++i) {  // the files that one names are checked behind it
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
    all.files.push_back(std::move(result));
    if (!for_people) continue;
    // A file that is no calibration has no result.
    const std::string text = (all.files.size() > 1 ? "\n" : "") + check_text(all.files.back(), arguments.verbose);
    all.files.back().report.is_calibration ? console.say(text, all.files.back().report.verdict.word) : console.say_aside(text);
  }
  if (all.files.empty()) {
    console.error("no calibration in " + enumerated(arguments.files) + " (" + std::to_string(all.skipped.size()) +
                  " files looked at)");
    exit_code = worse(exit_code, ExitCode::kBadInput);
  }
  if (for_people) console.say(check_summary(all));
  if (arguments.json) console.out(check_json(all, console));
  if (arguments.sarif) console.out(check_sarif(all));
  return exit_code;
}

void add_options(Options& options, CheckArguments& arguments) {
  CheckRequest& request = arguments.request;
  options.positional("FILE", "Calibration file(s) or folders; '-' is standard input", arguments.files, false);
  add_input_options(options, request.inputs);
  add_join_option(options, request.inputs);
  // Refused: a file is looked at as it stands.
  options.hide(all_changes());
  options.hide({"--with"});
  add_program_option(options,
                     "The program the file is meant for; if it reads another format, what convert would make of it: " +
                         enumerated(program_ids(), "or") + " (default: the format's own)",
                     request.program);
  options.group(OptionGroup::kOutput);
  options.value("--explain", "CODE", "The story behind a finding's code, or the meaning of any code in brackets",
                [&arguments](const std::string& id) { return take_code(id, arguments.explain); });
  options.flag("--list-codes", "All codes with what they mean", arguments.list_codes);
  options.group(OptionGroup::kProof);
  options.each("--ignore", "CODE", "Leave findings of that code out; may be given several times",
               [&request](const std::string& code) -> std::optional<std::string> {
                 const CodeInfo* const row = find_code(code);
                 if (row == nullptr) return no_code(code);
                 request.ignored.push_back(row->code);
                 return std::nullopt;
               });
  options.value("--fail-on", "SEVERITY", "Exit with 1 from this severity on: error (default) or warning",
                [&arguments](const std::string& word) -> std::optional<std::string> {
                  if (word != "error" && word != "warning") return "--fail-on is error or warning, not '" + word + "'";
                  arguments.fail_on_warnings = word == "warning";
                  return std::nullopt;
                });
  options.group(OptionGroup::kTarget);
  options.flag("--fix",
               "Show the fixes that are certain (a decimal point, quotes, a header, blanks for TABs) as a diff, and check "
               "the fixed file",
               arguments.fix);
  options.flag("--write", "With --fix: write them into the file", arguments.write);
  options.group(OptionGroup::kOutput);
  add_json_option(options, arguments.json);
  add_verbose_option(options, "And what was looked at, and what cannot be decided", arguments.verbose);
  options.flag("--sarif", "SARIF 2.1.0 on standard output, for CI services", arguments.sarif);
  options.footer(
      "Exit codes: 0 nothing that --fail-on names; 1 something; 2 no calibration; 3 usage; 4 input/output.\n\n"
      "Example:\n  fca-io check camchain.yaml\n  fca-io check --explain poses-contradict\n");
}

}  // namespace

void add_check_command(Application& application) {
  application.add("check", "What is wrong with a file, what happens if it is used, and how to fix it",
                  [](Options& options) -> RunCommand {
                    const auto arguments = std::make_shared<CheckArguments>();
                    add_options(options, *arguments);
                    return [arguments](const TypedOptions&, Console& console) { return run_check(*arguments, console); };
                  });
}

}  // namespace fca::cli
