// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a calibration file, and what a program would be given instead of it.
#pragma once

#include <fca/formats/check.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>
#include <vector>

namespace fca {

/// Of the inputs what says how a file is to be understood counts: format, image size, OpenCV model, largest angle. Every file
/// is looked at as it stands.
struct CheckRequest {
  Inputs inputs;
  const consumers::Consumer* program = nullptr;  ///< The program that the file is meant for; null: the format's own.
  std::vector<Code> ignored;                     ///< Findings with their ids are left out.
};

struct CheckResult {
  text::Source source;
  CheckReport report;
  /// What converting it gives: for a program that does not read its format, or where its own understands that better.
  std::optional<ConvertResult> instead = {};
  bool is_opened = true;  ///< False: the program that was asked about never opens such a file of its folder.
};

/// Checks one file. Files that it names as parts of it (CheckReport::parts) are checked by requests of their own.
[[nodiscard]] CheckResult check(const CheckRequest& request, const text::Source& source, Files& files);

/// The file with every fix that is certain (fca::fixed_source); nothing if there is none.
[[nodiscard]] std::optional<text::Source> with_fixes(const CheckRequest& request, const text::Source& source);

}  // namespace fca
