// SPDX-License-Identifier: BSD-3-Clause
#include "application.h"

#include "completion.h"
#include "help_text.h"
#include "manual.h"
#include "other_names.h"
#include "output.h"
#include "words.h"

#include <fca/formats/text/prose.h>
#include <fca/toolkit/files.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

constexpr const char* kVersionFlag = "--version";

}  // namespace

struct Application::Parser {
  CLI::App app{
      "fca-io makes camera calibration files interoperable: reads them, says what they mean, converts them to other formats\n"
      "and camera models, and proves that the program that reads the result understands it as meant."};
  RunCommand chosen;
  std::optional<Options> options;  ///< Of the subcommand that was chosen.
  std::vector<std::string> given;  ///< The words of the command line.

  struct Command {
    std::string name;
    std::string description;
    std::function<RunCommand(Options& options)> define;
  };
  std::vector<Command> commands;

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Command& command : commands) names.push_back(command.name);
    return names;
  }

  /// The parser gets to know the command; its options when it is met.
  void make(const Command& command) {
    CLI::App* const subcommand = app.add_subcommand(command.name, command.description);
    subcommand->allow_extras();  // they are refused without an exception
    subcommand->preparse_callback([this, subcommand, define = command.define](std::size_t /*words*/) {
      options.emplace(*subcommand, given);
      chosen = define(*options);
      options->refuse_empty_values();
    });
  }

  /// The command of the first word, or where there is none, all of them.
  void make_needed() {
    const auto first = given.empty() ? commands.end() : std::ranges::find(commands, given.front(), &Command::name);
    if (first != commands.end()) return make(*first);
    if (given.size() == 1 && given.front() == kVersionFlag) return;
    for (const Command& command : commands) make(command);
  }

  /// The subcommand of that name, with its options; null: there is none.
  CLI::App* defined(const std::string& name) {
    const auto found = std::ranges::find(commands, name, &Command::name);
    if (found == commands.end()) return nullptr;
    CLI::App* const subcommand = app.get_subcommand(name);
    found->define(options.emplace(*subcommand));
    return subcommand;
  }

  /// What shells and the build ask for: `complete WORD...` says what may stand in place of the last word, one a line, then
  /// ":files" where that may be a path; `manual [COMMAND]` is a manual page.
  std::optional<std::string> answer(std::span<const std::string> words) {
    const bool is_manual = !words.empty() && words.front() == "manual";
    if (!is_manual && (words.empty() || words.front() != "complete")) return std::nullopt;
    for (const Command& command : commands) make(command);
    std::vector<std::string> further(words.begin() + 1, words.end());
    if (further.size() > 1 && further.front() != "help") further = in_usual_names(std::move(further));
    CLI::App* const command = further.empty() ? nullptr : defined(further.front());
    if (is_manual && (command != nullptr || further.empty()) && further.size() < 2) return manual_page(app, command);
    if (is_manual) return std::nullopt;
    const Completion completion = completion_of(app, command, further);
    std::string text;
    for (const std::string& word : completion.words) text += word + "\n";
    return text + (completion.files ? ":files\n" : "");
  }

  /// Is the command's document promised, and how? `rest`: what parsing has left.
  [[nodiscard]] JsonShape promised_json(const std::vector<std::string>& rest) const;
};

Application::Application() : parser_(std::make_unique<Parser>()) {
  CLI::App& app = parser_->app;
  app.name("fca-io");
  app.formatter(help_formatter());
  app.option_defaults()->group(std::string(title_of(OptionGroup::kOutput)));
  app.set_help_flag("-h,--help", "Print this help");
  app.set_version_flag(kVersionFlag, "fca-io " FCA_VERSION, "Print the version");
  app.require_subcommand(0, 1);
  app.footer(
      "fca-io FILE is short for fca-io show FILE; diff is compare, undistort is remap, help COMMAND prints a command's "
      "options.\n\n"
      "Example:\n"
      "  fca-io convert camchain.yaml --with imu.yaml --to orbslam3 -o settings.yaml\n\n"
      "Exit codes: 0 good; 1 do not use it, nothing written; 2 bad input; 3 usage; 4 input/output; 5 written, but the report\n"
      "could not be printed; 70 a bug.");
}

Application::~Application() = default;

void Application::add(const std::string& name, const std::string& description,
                      std::function<RunCommand(Options& options)> define) {
  parser_->commands.push_back({name, description, std::move(define)});
}

namespace {

JsonShape json_shape(bool json, bool json_lines) {
  if (json_lines) return JsonShape::kLines;
  return json ? JsonShape::kDocument : JsonShape::kNone;
}

/// The JSON that words ask for that no command has taken.
JsonShape json_asked_for(const std::vector<std::string>& words) {
  if (std::ranges::none_of(words, [](const std::string& word) { return word.starts_with("--json"); })) return JsonShape::kNone;
  CLI::App any;
  any.set_help_flag();
  any.allow_extras();
  Options options(any);
  bool json = false;
  bool json_lines = false;
  add_json_option(options, json);
  add_json_lines_option(options, json_lines);
  try {
    any.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError&) {
    return JsonShape::kNone;
  }
  return json_shape(json, json_lines);
}

/// `fca-io FILE` is `fca-io show FILE`, and with --to `fca-io convert FILE`: is the first word anything like a path, and no
/// command?
bool is_path(const std::string& word) {
  return is_standard_input(word) || word.find_first_of("./") != std::string::npos ||
         CLI::detail::check_path(word.c_str()) != CLI::detail::path_type::nonexistent;
}

/// Of the first option that there is not: which was meant; nothing where none is near, or all are there.
std::optional<std::string> unknown_option(std::span<const std::string> words, const Options& options) {
  constexpr std::string_view kDashes = "--";
  const std::vector<std::string>& names = options.names();
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with(kDashes) || std::ranges::find(names, name) != names.end()) continue;
    std::vector<std::string> bare;
    bare.reserve(names.size());
    for (const std::string& each : names) bare.push_back(each.substr(kDashes.size()));
    std::vector<std::string> near = text::nearest(name.substr(kDashes.size()), bare);
    if (near.empty()) return std::nullopt;
    for (std::string& each : near) each.insert(0, kDashes);
    return "unknown option '" + name + "'; did you mean " + text::enumerated(near, "or") + "?";
  }
  return std::nullopt;
}

/// Of words that no command takes.
std::string not_expected(std::span<const std::string> words, const std::vector<std::string>& further,
                         const std::optional<Options>& options) {
  const std::optional<std::string> unknown = options ? unknown_option(words, *options) : std::nullopt;
  return unknown.value_or(CLI::ExtrasError("", further).what());
}

/// What is wrong with the command line.
struct Refusal {
  std::string problem;
  std::string fix = {};
};

}  // namespace

JsonShape Application::Parser::promised_json(const std::vector<std::string>& rest) const {
  std::vector<std::string> words = app.remaining(true);
  words.insert(words.end(), rest.rbegin(), rest.rend());
  const auto is_given = [this](OptionKey key) { return options && options->has_flag(key); };
  return std::max(json_shape(is_given(OptionKey::kJson), is_given(OptionKey::kJsonLines)), json_asked_for(words));
}

ExitCode Application::run(std::span<const std::string> given, Console& console) {
  if (const std::optional<std::string> answer = parser_->answer(given)) {
    console.out(*answer);
    return ExitCode::kGood;
  }
  std::vector<std::string> words = in_usual_names({given.begin(), given.end()});
  const std::vector<std::string> names = parser_->names();
  const auto is_name = [&names](const std::string& word) { return std::ranges::find(names, word) != names.end(); };
  if (!words.empty() && (!words.front().starts_with('-') || is_standard_input(words.front())) && !is_name(words.front())) {
    if (!is_path(words.front())) {
      console.promise_json(json_asked_for(words));
      return console.refuse(ExitCode::kUsage, unknown_word("command", words.front(), names));
    }
    const auto is_target = [](const std::string& word) { return word == "--to" || word.starts_with("--to="); };
    words.insert(words.begin(), std::ranges::any_of(words, is_target) ? "convert" : "show");
  }
  std::vector<std::string> rest(words.rbegin(), words.rend());  // as CLI11 wants it
  parser_->given = words;
  parser_->make_needed();
  const bool named = !words.empty() && is_name(words.front());
  const auto usage_refusal = [&](const std::string& problem) {
    return Refusal{named ? words.front() + ": " + problem : problem,
                   (named ? "fca-io " + words.front() : "fca-io") + std::string(" --help")};
  };
  std::optional<Refusal> refusal;
  try {
    parser_->app.parse(rest);
    if (parser_->app.remaining_size(true) > 0) {
      refusal = usage_refusal(not_expected(words, parser_->app.remaining(true), parser_->options));
    } else if (const std::optional<std::string> problem = parser_->options ? parser_->options->finish() : std::nullopt) {
      refusal = {*problem};
    }
  } catch (const UsageProblem& problem) {
    refusal = {problem.sentence};
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      std::ostringstream text;
      parser_->app.exit(error, text, text);
      console.out(text.str());
      return ExitCode::kGood;
    }
    refusal = usage_refusal(error.what());
  }
  console.promise_json(parser_->promised_json(rest));
  if (refusal) return console.refuse(ExitCode::kUsage, refusal->problem, refusal->fix);
  if (!parser_->chosen) {
    console.err(parser_->app.help());
    return ExitCode::kUsage;
  }
  return parser_->chosen(parser_->options->typed(), console);
}

}  // namespace fca::cli
