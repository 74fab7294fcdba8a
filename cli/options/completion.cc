// SPDX-License-Identifier: BSD-3-Clause
#include "completion.h"

#include "candidates.h"
#include "other_names.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

/// The option of that name that wants a value, if there is one.
const CLI::Option* with_value(const CLI::App& command, const std::string& name) {
  if (!name.starts_with('-')) return nullptr;
  const auto options = command.get_options([&name](const CLI::Option* each) {
    return each->nonpositional() && each->get_items_expected_max() > 0 && each->check_name(name);
  });
  return options.empty() ? nullptr : options.front();
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options([](const CLI::Option* each) { return !each->get_group().empty(); })) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> beginning_with(const std::string& begun, const std::vector<std::string>& words) {
  std::vector<std::string> result;
  std::ranges::copy_if(words, std::back_inserter(result),
                       [&begun](const std::string& word) { return word.starts_with(begun); });
  return result;
}

}  // namespace

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

Completion completion_of(const CLI::App& app, const CLI::App* command, std::span<const std::string> words) {
  if (words.empty()) return {};
  const std::string& begun = words.back();
  const CLI::App& typed = command != nullptr ? *command : app;
  // bash has words of their own of "--to=orb".
  const bool is_joined = words.size() > 2 && words[words.size() - 2] == "=";
  const std::size_t before = words.size() - (is_joined ? 3 : 2);
  const CLI::Option* option = words.size() > 1 ? with_value(typed, words[before]) : nullptr;
  if (option != nullptr) {
    const std::string type = option->get_type_name();
    return {beginning_with(begun, candidates(type, words.first(words.size() - 1))), is_path_type(type)};
  }
  if (begun.starts_with('-')) return {beginning_with(begun, option_names(typed)), false};
  if (words.size() == 1) {
    std::vector<std::string> names = command_names(app);
    for (const OtherName& other : kOtherNames) names.emplace_back(other.typed);
    return {beginning_with(begun, names), true};
  }
  if (words.front() == "help") return {beginning_with(begun, command_names(app)), false};
  return {{}, true};
}

}  // namespace fca::cli
