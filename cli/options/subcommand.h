// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace fca::cli {

/// Adds a subcommand to the command. `add_options` is called when words of the command line are its own: to make the options of
/// all subcommands takes as long as an empty program's start. Its options refuse empty values, a script's unset variables.
void add_subcommand(CLI::App& app, const std::string& name, const std::string& description,
                    std::function<void(CLI::App& subcommand)> add_options);

}  // namespace fca::cli
