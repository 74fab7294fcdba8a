// SPDX-License-Identifier: BSD-3-Clause
#include "check.h"

#include "inputs.h"
#include "output.h"
#include "program.h"
#include "words.h"

#include <fca/formats/check.h>
#include <fca/formats/text/prose.h>

namespace fca::cli {

namespace {

std::string no_code(const std::string& word) { return unknown_code(word, "fca-io check --list-codes lists them"); }

/// The row that speaks of a code in general, else its first one.
std::optional<std::string> take_code(const std::string& word, const CodeInfo*& target) {
  target = find_check_code(word) != nullptr ? find_check_code(word) : find_code(word);
  return target != nullptr ? std::nullopt : std::optional(no_code(word));
}

std::optional<std::string> take_ignored(const std::string& word, std::vector<Code>& ignored) {
  const CodeInfo* const code = find_code(word);
  if (code == nullptr) return no_code(word);
  ignored.push_back(code->code);
  return std::nullopt;
}

std::optional<std::string> take_severity(const std::string& word, bool& fail_on_warnings) {
  if (word != "error" && word != "warning") return "--fail-on is error or warning, not '" + word + "'";
  fail_on_warnings = word == "warning";
  return std::nullopt;
}

std::optional<std::string> usage_error(const CheckArguments& arguments) {
  const Inputs& inputs = arguments.request.inputs;
  std::vector<std::string> changes = given_changes(inputs);
  if (!inputs.parts.empty()) changes.emplace_back("--with");
  if (!changes.empty()) return "check reads every file unchanged: " + text::enumerated(changes, "and") + " has no effect here";
  if (arguments.write && !arguments.fix) return "--write is for --fix";
  if (arguments.fix && (arguments.json || arguments.sarif))
    return "--fix shows a diff: it does not work with --json or --sarif";
  if (arguments.fix && arguments.write && reads_of_standard_input(arguments.files) > 0)
    return "--write cannot write to standard input";
  if (arguments.quiet && arguments.verbose) return "--quiet and --verbose exclude each other";
  if (arguments.json && arguments.sarif) return "--json and --sarif exclude each other";
  return std::nullopt;
}

}  // namespace

void add_check_options(Options& options, CheckArguments& arguments) {
  CheckRequest& request = arguments.request;
  options.positional("FILE", "Calibration file(s) or folders; '-' is standard input", arguments.files, false);
  add_input_options(options, request.inputs);
  add_imu_rate_option(options, request.inputs);
  add_join_option(options, request.inputs);
  // Refused: a file is looked at as it stands.
  options.hide(all_changes());
  options.hide({"--with"});
  add_program_option(
      options,
      "The program that will read the file; if it reads another format, check also shows what convert would write: " +
          text::enumerated(program_ids(), "or") + " (default: the format's own)",
      request.program);
  options.group(OptionGroup::kOutput);
  options.value("--explain", "CODE", "Explain the code of a finding, or any code that a message shows in brackets",
                [&arguments](const std::string& id) { return take_code(id, arguments.explain); });
  options.flag("--list-codes", "List all codes of findings with their meanings", arguments.list_codes);
  options.group(OptionGroup::kProof);
  options.each("--ignore", "CODE", "Leave out findings with this code; repeatable",
               [&request](const std::string& word) { return take_ignored(word, request.ignored); });
  options.value("--fail-on", "error|warning", "Exit with 1 from this severity on: error (default) or warning",
                [&arguments](const std::string& word) { return take_severity(word, arguments.fail_on_warnings); });
  options.group(OptionGroup::kTarget);
  options.flag("--fix",
               "Show the fixes that are certain (a decimal point, quotes, a header, spaces for TABs) as a diff, and check the "
               "fixed file",
               arguments.fix);
  options.flag("--write", "With --fix: write them into the file", arguments.write);
  options.group(OptionGroup::kOutput);
  add_json_option(options, arguments.json);
  add_verbose_option(options, "Also what was checked, and what could not be decided", arguments.verbose);
  add_quiet_option(options, "Only files with findings, and one summary line", arguments.quiet);
  options.flag("--sarif", "SARIF 2.1.0 on standard output, for CI services", arguments.sarif);
  options.footer(
      "Exit codes: 0 no finding that --fail-on counts; 1 at least one; 2 no calibration; 3 usage; 4 "
      "input/output.\n\nExample:\n  fca-io check camchain.yaml\n  fca-io check --explain poses-contradict\n");
  options.afterwards([&arguments] { return usage_error(arguments); });
}

}  // namespace fca::cli
