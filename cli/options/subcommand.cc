// SPDX-License-Identifier: BSD-3-Clause
#include "subcommand.h"

#include <utility>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

void refuse_empty_values(CLI::App& command) {
  const CLI::Validator not_empty([](const std::string& value) { return value.empty() ? "an empty value" : std::string(); }, "");
  for (CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() > 0) option->check(not_empty);
  }
}

}  // namespace

void add_subcommand(CLI::App& app, const std::string& name, const std::string& description,
                    std::function<void(CLI::App& subcommand)> add_options) {
  CLI::App* const subcommand = app.add_subcommand(name, description);
  subcommand->preparse_callback([subcommand, add = std::move(add_options)](std::size_t /*remaining_words*/) {
    add(*subcommand);
    refuse_empty_values(*subcommand);
  });
}

}  // namespace fca::cli
