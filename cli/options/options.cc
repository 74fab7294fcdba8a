// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "help_text.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

CLI::Validator decimal_number() {
  const auto problem = [](const std::string& value) {
    return value.empty() || text::parse_real(value) ? std::string() : "'" + value + "' is not a decimal number";
  };
  return {problem, ""};
}

/// The help does not show the range.
CLI::Validator whole_number_in(int least, int most) { return CLI::Range(least, most).description(""); }

void check(const std::optional<std::string>& problem) {
  if (problem) throw UsageProblem{*problem};
}

/// One value each time, so that what follows is no further one.
void take_one_each_time(CLI::Option& option) { option.expected(1)->allow_extra_args(false)->take_all(); }

bool is_long(std::string_view name) { return name.starts_with("--"); }

/// "-o" in "-o", "-ofile" and "-vo"
bool is_of_short_names(std::string_view word) { return word.starts_with('-') && !is_long(word); }

/// May the word be the option, alone or with its value?
bool may_name(std::string_view word, std::string_view name) {
  if (is_long(name)) return word.starts_with(name) && (word.size() == name.size() || word[name.size()] == '=');
  return is_of_short_names(word) && word.find(name.back()) != std::string_view::npos;
}

bool asks_for_help(std::string_view word) { return may_name(word, "--help") || may_name(word, "-h"); }

}  // namespace

Options::Options(CLI::App& command, std::optional<std::vector<std::string>> words)
    : command_(command), words_(std::move(words)) {
  if (words_ && std::ranges::any_of(*words_, asks_for_help)) words_.reset();
  for (const CLI::Option* option : command_.get_options()) {
    for (const std::string& name : option->get_lnames()) names_.push_back("--" + name);
  }
  group(OptionGroup::kOutput);
}

bool Options::add_names(const std::string& names) {
  bool is_named = !words_;
  for (std::string_view rest = names; !rest.empty();) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    const std::string_view name = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (is_long(name)) names_.emplace_back(name);
    is_named = is_named || std::ranges::any_of(*words_, [name](const std::string& word) { return may_name(word, name); });
  }
  return is_named;
}

void Options::group(OptionGroup group) { command_.option_defaults()->group(std::string(title_of(group))); }

void Options::positional(const std::string& name, const std::string& help, std::vector<std::string>& target, bool required) {
  command_.add_option(name, target, help)->required(required);
}

void Options::one_positional(const std::string& name, const std::string& help, std::vector<std::string>& target,
                             bool required) {
  command_
      .add_option_function<std::string>(
          name, [&target](const std::string& word) { target = {word}; }, help)
      ->required(required);
}

void Options::value(const std::string& name, const std::string& type, const std::string& help, TakeWord take, OptionKey key) {
  if (!add_names(name)) return;
  const CLI::Option* const option =
      command_
          .add_option_function<std::string>(
              name, [take = std::move(take)](const std::string& word) { check(take(word)); }, help)
          ->type_name(type);
  keys_.emplace(option, key);
}

void Options::value(const std::string& name, const std::string& type, const std::string& help, std::string& target) {
  if (!add_names(name)) return;
  command_.add_option(name, target, help)->type_name(type);
}

void Options::number(const std::string& name, const std::string& type, const std::string& help, std::optional<double>& target) {
  if (!add_names(name)) return;
  command_.add_option(name, target, help)->type_name(type)->check(decimal_number());
}

void Options::number(const std::string& name, const std::string& type, const std::string& help,
                     std::function<std::optional<std::string>(double)> take) {
  if (!add_names(name)) return;
  command_
      .add_option_function<double>(
          name, [take = std::move(take)](double number) { check(take(number)); }, help)
      ->type_name(type)
      ->check(decimal_number());
}

void Options::whole_number(const std::string& name, const std::string& type, const std::string& help,
                           std::function<std::optional<std::string>(int)> take) {
  if (!add_names(name)) return;
  command_
      .add_option_function<int>(
          name, [take = std::move(take)](int number) { check(take(number)); }, help)
      ->type_name(type)
      ->check(decimal_number());
}

void Options::count(const std::string& name, const std::string& type, const std::string& help, std::size_t& target, int least,
                    int most) {
  if (!add_names(name)) return;
  command_.add_option(name, target, help)->type_name(type)->check(whole_number_in(least, most));
}

void Options::each(const std::string& name, const std::string& type, const std::string& help, TakeWord take) {
  if (!add_names(name)) return;
  take_one_each_time(*command_
                          .add_option_function<std::vector<std::string>>(
                              name,
                              [take = std::move(take)](const std::vector<std::string>& words) {
                                for (const std::string& word : words) check(take(word));
                              },
                              help)
                          ->type_name(type));
}

void Options::each(const std::string& name, const std::string& type, const std::string& help,
                   std::vector<std::string>& target) {
  if (!add_names(name)) return;
  take_one_each_time(*command_.add_option(name, target, help)->type_name(type));
}

void Options::flag(const std::string& name, const std::string& help, bool& target, OptionKey key) {
  if (!add_names(name)) return;
  keys_.emplace(command_.add_flag(name, target, help), key);
}

void Options::count(const std::string& name, const std::string& help, int& target) {
  if (!add_names(name)) return;
  command_
      .add_flag_function(
          name, [&target](std::int64_t times) { target = static_cast<int>(times); }, help)
      ->disable_flag_override();
}

void Options::flag_pair(const std::string& on, const std::string& on_help, const std::string& off, const std::string& off_help,
                        bool& target) {
  const bool first_is_named = add_names(on);
  if (!add_names(off) && !first_is_named) return;
  CLI::Option* const first = command_
                                 .add_flag_function(
                                     on, [](std::int64_t) {}, on_help)
                                 ->disable_flag_override();
  command_
      .add_flag_function(
          off, [&target](std::int64_t) { target = false; }, off_help)
      ->disable_flag_override()
      ->excludes(first);
}

void Options::exclusive_flags(const std::vector<Flag>& flags, const std::string& problem) {
  const auto given = std::make_shared<int>(0);
  for (const Flag& flag : flags) {
    if (!add_names(flag.name)) continue;
    command_
        .add_flag_function(
            flag.name,
            [given, problem, take = flag.take](std::int64_t) {
              if (++*given > 1) throw UsageProblem{problem};
              take();
            },
            flag.help)
        ->disable_flag_override();
  }
}

void Options::hide(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (CLI::Option* const option = command_.get_option_no_throw(name)) option->group("");
  }
}

void Options::footer(const std::string& text) { command_.footer(text); }

void Options::refuse_empty_values() {
  const CLI::Validator not_empty([](const std::string& value) { return value.empty() ? "an empty value" : std::string(); }, "");
  for (CLI::Option* option : command_.get_options()) {
    if (option->get_items_expected_max() > 0) option->check(not_empty);
  }
}

std::optional<std::string> Options::finish() const {
  for (const FinishRequest& finish : finish_) {
    if (std::optional<std::string> problem = finish()) return problem;
  }
  return std::nullopt;
}

OptionKey Options::key_of(const CLI::Option* option) const {
  const auto found = keys_.find(option);
  return found != keys_.end() ? found->second : OptionKey::kOther;
}

bool Options::has_flag(OptionKey key) const {
  return std::ranges::any_of(keys_, [key](const auto& entry) {
    return entry.second == key && entry.first->count() > 0 && entry.first->results().back() == "true";
  });
}

TypedOptions Options::typed() const {
  TypedOptions result;
  std::map<const CLI::Option*, std::size_t> used;  // values of each
  for (const CLI::Option* option : command_.parse_order()) {
    TypedOption typed;
    typed.name = option->get_name();
    typed.key = key_of(option);
    typed.positional = option->get_positional();
    typed.about_output = !typed.positional && option->get_group() == title_of(OptionGroup::kOutput);
    if (option->get_items_expected_max() > 0) typed.value = option->results().at(used[option]++);
    result.push_back(std::move(typed));
  }
  return result;
}

}  // namespace fca::cli
