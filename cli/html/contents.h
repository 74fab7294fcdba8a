// SPDX-License-Identifier: BSD-3-Clause
// All that a page tells, before it is laid out.
#pragma once

#include "commands/check/check_command.h"
#include "commands/show/show_command.h"
#include "toolkit/conversion.h"
#include "toolkit/model_candidates.h"

#include <optional>
#include <string>
#include <vector>

namespace fca::cli {

struct ReportContents {
  std::string title;                ///< The names of the files, without their folders.
  ShownFile shown;                  ///< Has a calibration.
  std::vector<CheckedFile> checks;  ///< Of its files.
  std::optional<double> max_angle_rad;

  /// What `convert` would do; without a format (--model alone) just the cameras.
  std::optional<ConvertOutcome> conversion;
  const Format* to = nullptr;

  /// Under --model all: for each camera of the calibration all models.
  std::vector<std::vector<Candidate>> candidates;

  std::string command;  ///< That made the page.
  std::string convert;  ///< That would write the file; empty: none.
};

}  // namespace fca::cli
