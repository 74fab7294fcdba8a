// SPDX-License-Identifier: BSD-3-Clause
// Checks a calibration file, and converts it if a program needs another file instead.
#pragma once

#include <fca/formats/check.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>
#include <vector>

namespace fca {

/// A check uses only those inputs that say how to read a file: format, image size, OpenCV model, largest angle. It ignores
/// the other inputs.
struct CheckRequest {
  Inputs inputs;
  const consumers::Consumer* program = nullptr;  ///< The program that will read the file. Null: the format's own program.
  std::vector<Code> ignored;                     ///< Findings with the ids of these codes are not reported.
};

struct CheckResult {
  text::Source source;
  CheckReport report;
  /// A conversion of the file, if the program does not read its format, or if its own program reads the converted file better.
  std::optional<ConvertResult> instead = {};
  bool is_opened = true;  ///< False if the request's program never opens this file in its folder.
};

/// Checks one file. It does not check the files that this file names as its parts (CheckReport::parts).
[[nodiscard]] CheckResult check(const CheckRequest& request, const text::Source& source, Files& files);

/// The file with all certain fixes applied (fca::fixed_source). nullopt if there is nothing to fix.
[[nodiscard]] std::optional<text::Source> with_fixes(const CheckRequest& request, const text::Source& source);

}  // namespace fca
