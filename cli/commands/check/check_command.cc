// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.h"

#include "options/subcommand.h"
#include "shell/calibration_files.h"
#include "shell/output_file.h"
#include "shell/words.h"
#include "toolkit/conversion_preview.h"
#include "toolkit/program_reading.h"

#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <filesystem>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

std::vector<std::string> code_names() {
  std::vector<std::string> names;
  for (const CheckCode& code : check_codes()) names.emplace_back(code.code);
  return names;
}

/// What is wrong with the options, in words.
std::optional<std::string> problem_with(const CheckArguments& arguments) {
  if (const std::optional<std::string> error = check(arguments.reading)) return error;
  if (!arguments.program.empty() && find_program(arguments.program) == nullptr)
    return unknown_word("program", arguments.program, program_ids());
  for (const std::string& code : arguments.ignored) {
    if (find_check_code(code) == nullptr)
      return unknown_word("code", code, code_names(), "fca-io check --list-codes lists them");
  }
  if (arguments.fail_on != "error" && arguments.fail_on != "warning")
    return "--fail-on is error or warning, not '" + arguments.fail_on + "'";
  if (!arguments.reading.with.empty() || arguments.reading.join || arguments.reading.cameras ||
      changes_images(arguments.reading)) {
    return "check looks at every file as it stands: --with, --join, --camera, --crop, --binning and --resize have no use here";
  }
  if (arguments.write && !arguments.fix) return "--write is for --fix";
  if (arguments.fix && (arguments.json || arguments.sarif))
    return "--fix shows a diff: --json and --sarif have no use beside it";
  if (arguments.fix && arguments.write && std::ranges::find(arguments.files, "-") != arguments.files.end())
    return "--write cannot write to standard input";
  if (arguments.json && arguments.sarif) return "--json and --sarif exclude each other";
  return std::nullopt;
}

/// What there is to check a file by, for one with cameras or without.
CheckOptions options_for(const CheckArguments& arguments, bool with_cameras) {
  CheckOptions options;
  options.reading = {parse_size(arguments.reading.size), arguments.reading.opencv_model, false};
  options.from = arguments.reading.from.empty() ? nullptr : find_format(arguments.reading.from);
  options.max_angle_rad = max_angle_rad(arguments.reading);
  options.parts = true;
  if (!arguments.program.empty()) options.program = &reader_of(*find_program(arguments.program), with_cameras);
  return options;
}

CheckReport checked(const text::Source& source, const CheckArguments& arguments) {
  CheckReport report = check_file(source, options_for(arguments, true));
  if (report.holds_no_camera && !arguments.program.empty()) report = check_file(source, options_for(arguments, false));
  std::erase_if(report.findings, [&arguments](const Finding& finding) {
    return std::ranges::find(arguments.ignored, finding.code) != arguments.ignored.end();
  });
  return report;
}

/// Makes the certain mends: shows them, writes them if asked to, and goes on with the mended text.
ExitCode fix(text::Source& source, const CheckArguments& arguments, Console& console) {
  const bool with_cameras = !check_file(source, options_for(arguments, true)).holds_no_camera;
  const std::optional<text::Source> better = mended(source, options_for(arguments, with_cameras));
  if (!better) return ExitCode::kGood;
  console.say(source.name + ": " + (arguments.write ? "mended" : "would be mended (--write does it)") + "\n" +
              line_diff(source.bytes, better->bytes));
  source = *better;
  if (!arguments.write) return ExitCode::kGood;
  const OutputFile output{source.name, source.bytes};
  remove_leftovers(std::filesystem::path(source.name).parent_path().string());
  const std::optional<std::string> problem = write_files(std::span(&output, 1), true, false);
  if (!problem) return ExitCode::kGood;
  console.error(*problem);
  return ExitCode::kIo;
}

/// For a program of another format: what it would be given instead.
std::optional<ConvertOutcome> instead_of(const std::string& file, const CheckReport& report, const CheckArguments& arguments,
                                         Console& console) {
  const bool other_format =
      std::ranges::any_of(report.findings, [](const Finding& finding) { return finding.code == "program-other-format"; });
  if (!other_format || file == "-") return std::nullopt;
  return preview_conversion(file, arguments.reading, *find_program(arguments.program), console);
}

ExitCode code_of(const CheckReport& report, const CheckArguments& arguments) {
  if (!report.is_calibration) return ExitCode::kBadInput;
  const bool bad = report.has(Severity::kError) || (arguments.fail_on == "warning" && report.has(Severity::kWarning));
  return bad ? ExitCode::kJudgedBad : ExitCode::kGood;
}

/// The report of a file that could not be opened.
CheckReport unreadable(const Diagnostics& diagnostics) {
  CheckReport report;
  report.is_calibration = false;
  for (const Diagnostic& entry : diagnostics.entries())
    report.findings.push_back({entry.severity, entry.code, entry.message, {}, entry.fix, entry.where});
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
  if (const std::optional<std::string> error = problem_with(arguments)) return console.refuse(ExitCode::kUsage, *error);
  if (arguments.list_codes) {
    for (const CheckCode& code : check_codes()) console.say(padded(code.code, 28) + std::string(code.title) + "\n");
    return ExitCode::kGood;
  }
  if (!arguments.explain.empty()) {
    const CheckCode* code = find_check_code(arguments.explain);
    if (code == nullptr) {
      return console.refuse(ExitCode::kUsage,
                            unknown_word("code", arguments.explain, code_names(), "fca-io check --list-codes lists them"));
    }
    console.say(explanation(*code));
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
    std::optional<text::Source> source = text::read_source(file.path, diagnostics);
    if (!source) {
      if (!file.named) {
        all.skipped.push_back(file.path);
        continue;
      }
      console.show(diagnostics);
      exit_code = worse(exit_code, ExitCode::kIo);
      all.files.push_back({{file.path, {}}, unreadable(diagnostics), {}});
      continue;
    }
    if (arguments.fix) exit_code = worse(exit_code, fix(*source, arguments, console));
    CheckReport report = checked(*source, arguments);
    if (!report.is_calibration && !file.named) {
      all.skipped.push_back(file.path);
      continue;
    }
    add_parts(report.parts, i, files);
    exit_code = worse(exit_code, code_of(report, arguments));
    std::optional<ConvertOutcome> instead = instead_of(file.path, report, arguments, console);
    all.files.push_back({*std::move(source), std::move(report), std::move(instead)});
    if (!for_people) continue;
    // A file that is no calibration has no result.
    const std::string text = (all.files.size() > 1 ? "\n" : "") + check_text(all.files.back());
    all.files.back().report.is_calibration ? console.say(text) : console.say_aside(text);
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

void add_options(CLI::App& command, CheckArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command.add_option("FILE", arguments.files, "Calibration file(s) or folders; '-' is standard input");
  add_reading_options(command, arguments.reading);
  add_join_option(command, arguments.reading);
  // Refused: a file is looked at as it stands.
  for (const char* option : {"--with", "--join", "--camera", "--crop", "--binning", "--resize"})
    command.get_option(option)->group("");
  command
      .add_option("--for", arguments.program,
                  "The program the file is meant for; if it reads another format, what convert would make of it: " +
                      enumerated(program_ids(), "or") + " (default: the format's own)")
      ->type_name("PROGRAM");
  command.add_option("--explain", arguments.explain, "The story behind a finding's code")->type_name("CODE");
  command.add_flag("--list-codes", arguments.list_codes, "All codes with what they mean");
  take_one_each_time(
      *command.add_option("--ignore", arguments.ignored, "Leave findings of that code out; may be given several times")
           ->type_name("CODE"));
  command.add_option("--fail-on", arguments.fail_on, "Exit with 1 from this severity on: error (default) or warning")
      ->type_name("SEVERITY");
  command.add_flag("--fix", arguments.fix,
                   "Show the mends that are certain (a decimal point, quotes, a header, blanks for TABs) as a diff, and check "
                   "the mended file");
  command.add_flag("--write", arguments.write, "With --fix: write them into the file");
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.add_flag("--sarif", arguments.sarif, "SARIF 2.1.0 on standard output, for CI services");
  command.footer(
      "Exit codes: 0 nothing that --fail-on names; 1 something; 2 no calibration; 3 usage; 4 input/output.\n\n"
      "Example:\n  fca-io check camchain.yaml\n  fca-io check --explain poses-contradict\n");
  command.callback([&arguments, &run] { run = [&arguments](Console& console) { return run_check(arguments, console); }; });
}

}  // namespace

void add_check_command(CLI::App& app, CheckArguments& arguments, std::function<ExitCode(Console&)>& run) {
  add_subcommand(app, "check", "What is wrong with a file, what happens if it is used, and how to mend it",
                 [&arguments, &run](CLI::App& command) { add_options(command, arguments, run); });
}

}  // namespace fca::cli
