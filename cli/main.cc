// SPDX-License-Identifier: BSD-3-Clause
#include "commands/check/check_command.h"
#include "commands/compare/compare_command.h"
#include "commands/convert/convert_command.h"
#include "commands/evaluate/evaluate_command.h"
#include "commands/lists/list_commands.h"
#include "commands/points/project_command.h"
#include "commands/remap/remap_command.h"
#include "commands/report/report_command.h"
#include "commands/show/show_command.h"
#include "shell/words.h"

#include <fca/formats/consumers/missing_module.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

std::vector<std::string> subcommand_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(subcommand->get_name());
  return names;
}

/// `fca-io FILE` is `fca-io show FILE`; a word that is neither command nor anything like a path is a mistyped command.
void insert_show(std::vector<std::string>& words, const CLI::App& app, bool& mistyped) {
  if (words.empty() || (words.front().starts_with('-') && words.front() != "-")) return;
  const std::vector<std::string> names = subcommand_names(app);
  const std::string& first = words.front();
  if (std::ranges::find(names, first) != names.end()) return;
  const bool path = first == "-" || first.find_first_of("./") != std::string::npos ||
                    CLI::detail::check_path(first.c_str()) != CLI::detail::path_type::nonexistent;
  if (path) {
    words.insert(words.begin(), "show");
  } else {
    mistyped = true;
  }
}

int run(int argc, char** argv) {
  CLI::App app(
      "fca-io makes camera calibration files interoperable: reads them, says what they mean, converts them to other formats\n"
      "and camera models, and proves that the program that reads the result understands it as meant.");
  app.name("fca-io");
  app.set_version_flag("--version", "fca-io " FCA_VERSION);
  app.require_subcommand(0, 1);
  app.footer(
      "fca-io FILE is short for fca-io show FILE.\n\n"
      "Example:\n"
      "  fca-io convert camchain.yaml --with imu.yaml --to orbslam3 -o settings.yaml\n\n"
      "Exit codes: 0 good; 1 done but judged bad, nothing written; 2 bad input; 3 usage; 4 input/output; 70 a bug.");

  Console console;
  std::function<ExitCode(Console&)> chosen;
  ConvertArguments convert_arguments;
  ShowArguments show_arguments;
  CheckArguments check_arguments;
  CompareArguments compare_arguments;
  ProjectArguments project_arguments;
  ReportArguments report_arguments;
  RemapArguments remap_arguments;
  ListArguments list_arguments;
  EvaluateArguments evaluate_arguments;
  add_convert_command(app, convert_arguments, chosen);
  add_show_command(app, show_arguments, chosen);
  add_check_command(app, check_arguments, chosen);
  add_compare_command(app, compare_arguments, chosen);
  add_report_command(app, report_arguments, chosen);
  add_remap_command(app, remap_arguments, chosen);
  add_project_commands(app, project_arguments, chosen);
  add_list_commands(app, list_arguments, chosen);
  add_evaluate_command(app, evaluate_arguments, chosen);

  std::vector<std::string> words(argv + 1, argv + argc);
  convert_arguments.words = words;
  if (std::ranges::find(words, "--json") != words.end()) console.promise_json();
  bool mistyped = false;
  insert_show(words, app, mistyped);
  if (mistyped) {
    const std::vector<std::string> names = subcommand_names(app);
    return static_cast<int>(console.refuse(ExitCode::kUsage, unknown_word("command", words.front(), names)));
  }
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());  // as CLI11 wants it
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    const bool asked_for = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    if (asked_for) {
      app.exit(error);
      return static_cast<int>(console.finish(ExitCode::kGood));
    }
    const std::vector<std::string> names = subcommand_names(app);
    const bool named = !words.empty() && std::ranges::find(names, words.front()) != names.end();
    const std::string command = named ? "fca-io " + words.front() : "fca-io";
    return static_cast<int>(
        console.refuse(ExitCode::kUsage, named ? words.front() + ": " + error.what() : error.what(), command + " --help"));
  }
  if (!chosen) {
    console.err(app.help());
    return static_cast<int>(ExitCode::kUsage);
  }
  return static_cast<int>(console.finish(chosen(console)));
}

}  // namespace

}  // namespace fca::cli

int main(int argc, char** argv) {
  // A closed pipe is an error to report (exit 4), not a death without words.
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return fca::cli::run(argc, argv);
  } catch (const fca::consumers::MissingModule& error) {
    std::fprintf(stderr, "fca-io: %s; install fca-io again\n", error.what());
    return static_cast<int>(fca::cli::ExitCode::kIo);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fca-io: a bug, please report it: %s\n", error.what());
    return static_cast<int>(fca::cli::ExitCode::kBug);
  } catch (...) {
    std::fputs("fca-io: a bug, please report it: an exception of no known kind\n", stderr);
    return static_cast<int>(fca::cli::ExitCode::kBug);
  }
}
