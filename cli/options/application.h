// SPDX-License-Identifier: BSD-3-Clause
// The command line: subcommands, and which of them was asked for.
#pragma once

#include "options.h"
#include "shell/console.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fca::cli {

/// Does what a subcommand was asked for. `typed`: its options.
using RunCommand = std::function<ExitCode(const TypedOptions& typed, Console& console)>;

class Application {
 public:
  Application();
  ~Application();
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;

  /// Adds a subcommand. `define` is called when words of the command line are its own (to define the options of all subcommands
  /// takes as long as an empty program's start); what it returns is run when they have been parsed.
  void add(const std::string& name, const std::string& description, std::function<RunCommand(Options& options)> define);

  /// The same for a command of these arguments: `define(options, arguments)` defines its options; `act(arguments, console)`, or
  /// `act(arguments, typed, console)`, does what they ask for.
  template <class Arguments, class Define, class Act>
  void add(const std::string& name, const std::string& description, Define define, Act act) {
    add(name, description, [define, act](Options& options) -> RunCommand {
      const auto arguments = std::make_shared<Arguments>();
      define(options, *arguments);
      return [arguments, act](const TypedOptions& typed, Console& console) {
        if constexpr (std::is_invocable_v<Act, const Arguments&, const TypedOptions&, Console&>) {
          return act(*arguments, typed, console);
        } else {
          return act(*arguments, console);
        }
      };
    });
  }

  /// Parses the words, and runs what they ask for.
  [[nodiscard]] ExitCode run(std::span<const std::string> words, Console& console);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace fca::cli
