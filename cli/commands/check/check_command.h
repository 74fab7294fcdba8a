// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"
#include "options/check.h"
#include "shell/console.h"

#include <fca/code.h>
#include <fca/toolkit/check.h>

#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

/// Everything that was checked.
struct CheckedFiles {
  std::vector<CheckResult> files;
  std::vector<std::string> skipped;  ///< Met in folders: no calibrations.
};

void add_check_command(Application& application);

/// How much of a file's report is printed.
enum class CheckDetail : std::uint8_t {
  kFindings,    ///< What is wrong.
  kUsual,       ///< And who reads it.
  kEverything,  ///< And what was looked at.
};

/// `in_detail`: and what was looked at, and what cannot be decided.
[[nodiscard]] std::string check_text(const CheckResult& file, CheckDetail detail);
/// One line for all, where there are several.
[[nodiscard]] std::string check_summary(const CheckedFiles& checked);
[[nodiscard]] std::string check_json(const CheckedFiles& checked, const Console& console);
/// SARIF 2.1.0, as CI services show it next to the lines.
[[nodiscard]] std::string check_sarif(const CheckedFiles& checked);
/// What changed between two texts, line by line: "-" and "+" lines after "@ LINE" of the old text.
[[nodiscard]] std::string line_diff(std::string_view before, std::string_view after);
/// The long story of a code; of one that no finding has, its sentences.
[[nodiscard]] std::string explanation(const CodeInfo& code);

}  // namespace fca::cli
