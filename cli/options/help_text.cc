// SPDX-License-Identifier: BSD-3-Clause
#include "help_text.h"

#include "shell/words.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

constexpr std::size_t kNames = 24;  ///< Columns of an option's name; its explanation stands to the right.

/// A name and its explanation.
std::string entry(const std::string& name, const std::string& explanation, std::size_t indent) {
  std::string line = "  " + name;
  if (line.size() + 1 > indent) {
    line += "\n" + std::string(indent, ' ');
  } else {
    line.append(indent - line.size(), ' ');
  }
  return line + in_columns(explanation, indent, indent) + "\n";
}

/// Lines that begin with a blank stay; those between them are paragraphs.
std::string paragraphs(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  std::string paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) result += in_columns(paragraph, 0, 0) + "\n";
    paragraph.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.front() != ' ') {
      paragraph += line + " ";
      continue;
    }
    end_paragraph();
    result += line + "\n";
  }
  end_paragraph();
  return result;
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode /*mode*/) const override {
    std::string text = paragraphs(app->get_description()) + make_usage(app, std::move(name)) + positionals(*app);
    for (const OptionGroup each : kOptionGroups) text += group(*app, title_of(each));
    text += commands(*app);
    return app->get_footer().empty() ? text : text + "\n" + paragraphs(app->get_footer());
  }

 private:
  [[nodiscard]] static std::string positionals(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->get_positional(); }))
      text += entry(option->get_name(true, false), option->get_description(), kNames);
    return text.empty() ? text : "\n" + text;
  }

  [[nodiscard]] static std::string group(const CLI::App& app, std::string_view title) {
    std::string text;
    for (const CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->nonpositional(); })) {
      if (option->get_group() != title) continue;
      const std::string type = option->get_type_size() == 0 ? "" : " " + option->get_type_name();
      text += entry(option->get_name(false, true) + type, option->get_description(), kNames);
    }
    return text.empty() ? text : "\n" + std::string(title) + ":\n" + text;
  }

  [[nodiscard]] static std::string commands(const CLI::App& app) {
    constexpr std::size_t kCommands = 13;
    std::string text;
    for (const CLI::App* command : app.get_subcommands({}))
      text += entry(command->get_name(), command->get_description(), kCommands);
    return text.empty() ? text : "\nCommands:\n" + text;
  }
};

}  // namespace

std::string_view title_of(OptionGroup group) {
  switch (group) {
    case OptionGroup::kTarget:
      return "What to write";
    case OptionGroup::kReading:
      return "How to read the input";
    case OptionGroup::kLens:
      return "What counts as lens";
    case OptionGroup::kProof:
      return "Proof and limits";
    case OptionGroup::kOutput:
      return "Output";
  }
  return "";
}

std::shared_ptr<CLI::FormatterBase> help_formatter() { return std::make_shared<HelpFormatter>(); }

}  // namespace fca::cli
