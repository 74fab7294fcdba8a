// SPDX-License-Identifier: BSD-3-Clause
#include "manual.h"

#include "help_text.h"
#include "options.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

/// Text as man shows it, whatever its letters mean to roff.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";  // else a hyphen, which nobody can copy into a shell
    } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
      result += std::string("\\&") + c;
    } else {
      result += c;
    }
  }
  return result;
}

std::string section(const std::string& title) { return ".SH " + title + "\n"; }

/// What stands at the left, and its explanation.
std::string entry(const std::string& name, const std::string& explanation) {
  return ".TP\n.B " + plain(name) + "\n" + plain(explanation) + "\n";
}

/// Lines that begin with a blank stay as they are: examples.
std::string paragraphs(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  bool is_example = false;
  for (std::string line; std::getline(lines, line);) {
    const bool begins_blank = line.starts_with(' ');
    if (begins_blank != is_example) result += begins_blank ? ".EX\n" : ".EE\n";
    is_example = begins_blank;
    result += line.empty() ? ".PP\n" : plain(line) + "\n";
  }
  return is_example ? result + ".EE\n" : result;
}

std::string name_with_value(const CLI::Option& option) {
  return option.get_name(false, true) + (option.get_type_size() == 0 ? "" : " " + option.get_type_name());
}

std::string positionals_of(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options([](const CLI::Option* each) { return each->get_positional(); }))
    text += entry(option->get_name(true, false), option->get_description());
  return text;
}

std::string options_of(const CLI::App& command) {
  std::string text;
  for (const OptionGroup group : kOptionGroups) {
    std::string entries;
    for (const CLI::Option* option : command.get_options([](const CLI::Option* each) { return each->nonpositional(); })) {
      if (option->get_group() == title_of(group)) entries += entry(name_with_value(*option), option->get_description());
    }
    if (!entries.empty()) text += ".SS " + std::string(title_of(group)) + "\n" + entries;
  }
  return text;
}

std::string synopsis(const CLI::App& app, const CLI::App* command) {
  if (command == nullptr) return ".B " + plain(app.get_name()) + "\nCOMMAND [OPTION...] ...\n";
  std::string text = ".B " + plain(app.get_name()) + " " + plain(command->get_name()) + "\n[OPTION...]";
  for (const CLI::Option* option : command->get_options([](const CLI::Option* each) { return each->get_positional(); })) {
    const bool several = option->get_items_expected_max() > 1;
    const std::string word = option->get_name(true, false) + (several ? "..." : "");
    text += " " + plain(option->get_required() ? word : "[" + word + "]");
  }
  return text + "\n";
}

std::string commands_of(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    text += entry(command->get_name(), command->get_description());
  return text;
}

std::string others(const CLI::App& app, const CLI::App* command) {
  std::string text;
  if (command != nullptr) text = ".BR " + plain(app.get_name()) + " (1)";
  for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (each == command) continue;
    text += (text.empty() ? ".BR " : ",\n.BR ") + plain(app.get_name() + "-" + each->get_name()) + " (1)";
  }
  return text + "\n";
}

}  // namespace

std::string manual_page(const CLI::App& app, const CLI::App* command) {
  const CLI::App& shown = command != nullptr ? *command : app;
  const std::string name = app.get_name() + (command != nullptr ? "-" + command->get_name() : "");
  std::string title = name;
  std::ranges::transform(title, title.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  // The first sentence of the program, the description of a command.
  std::string what = shown.get_description();
  what.resize(std::min(what.size(), what.find_first_of(":\n")));
  std::string text = ".TH " + plain(title) + " 1 \"\" \"fca\\-io " FCA_VERSION "\" \"User Commands\"\n";
  text += section("NAME") + plain(name) + " \\- " + plain(what) + "\n";
  text += section("SYNOPSIS") + synopsis(app, command);
  text += section("DESCRIPTION") + paragraphs(shown.get_description()) + positionals_of(shown);
  text += section("OPTIONS") + options_of(shown);
  if (command == nullptr) text += section("COMMANDS") + commands_of(app);
  if (!shown.get_footer().empty()) text += section("NOTES") + paragraphs(shown.get_footer());
  return text + section("SEE ALSO") + others(app, command);
}

}  // namespace fca::cli
