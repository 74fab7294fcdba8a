// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/console.h"
#include "toolkit/conversion.h"
#include "toolkit/reading.h"

#include <fca/formats/check.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace fca::cli {

struct CheckArguments {
  std::vector<std::string> files;
  ReadingOptions reading;
  std::string program;  ///< --for
  std::string explain;
  bool list_codes = false;
  std::vector<std::string> ignored;
  std::string fail_on = "error";
  bool fix = false;
  bool write = false;
  bool json = false;
  bool sarif = false;
};

/// What one file came to.
struct CheckedFile {
  text::Source source;
  CheckReport report;
  std::optional<ConvertOutcome> instead;  ///< What `convert` would make of it for a program that does not read its format.
};

/// Everything that was checked.
struct CheckedFiles {
  std::vector<CheckedFile> files;
  std::vector<std::string> skipped;  ///< Met in folders: no calibrations.
};

void add_check_command(CLI::App& app, CheckArguments& arguments, std::function<ExitCode(Console&)>& run);

[[nodiscard]] std::string check_text(const CheckedFile& file);
/// One line for all, where there are several.
[[nodiscard]] std::string check_summary(const CheckedFiles& checked);
[[nodiscard]] std::string check_json(const CheckedFiles& checked, const Console& console);
/// SARIF 2.1.0, as CI services show it beside the lines.
[[nodiscard]] std::string check_sarif(const CheckedFiles& checked);
/// What changed between two texts, line by line: "-" and "+" lines behind "@ LINE" of the old text.
[[nodiscard]] std::string line_diff(std::string_view before, std::string_view after);
/// The long story of a code.
[[nodiscard]] std::string explanation(const CheckCode& code);

}  // namespace fca::cli
