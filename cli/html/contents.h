// SPDX-License-Identifier: BSD-3-Clause
// All that a page tells, before it is laid out.
#pragma once

#include "commands/show/show_command.h"

#include <fca/toolkit/report.h>

#include <optional>
#include <string>
#include <vector>

namespace fca::cli {

struct ReportContents {
  std::string title;                ///< The names of the files, without their folders.
  ShownFile shown;                  ///< Has a calibration.
  std::vector<CheckResult> checks;  ///< Of its files.
  std::optional<double> max_angle_rad;

  /// What `convert` would do; without a format just the cameras.
  std::optional<ConvertResult> conversion;
  const Format* to = nullptr;

  /// All models of each camera; empty where they were not asked for.
  std::vector<ModelsResult::OfCamera> models;

  Verdict verdict;  ///< As ReportResult's.

  std::string command;  ///< That made the page.
  std::string convert;  ///< That would write the file; empty: none.
};

}  // namespace fca::cli
