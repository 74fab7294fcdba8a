// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fca::cli {

/// The manual page (man's roff) of the program, or of one of its subcommands, whose options are defined.
[[nodiscard]] std::string manual_page(const CLI::App& app, const CLI::App* command);

}  // namespace fca::cli
