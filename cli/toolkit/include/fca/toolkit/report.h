// SPDX-License-Identifier: BSD-3-Clause
// All that a report on a calibration tells: what it means, what is wrong with it, and what converting it does.
#pragma once

#include <fca/toolkit/check.h>
#include <fca/toolkit/convert.h>
#include <fca/toolkit/models.h>
#include <fca/toolkit/read.h>

#include <optional>
#include <vector>

namespace fca {

struct ReportRequest {
  /// Its inputs are what the report is about. Without `to` and `into` there is no file to be written: the cameras are fitted to
  /// `model` alone or, if that is null, not at all.
  ConvertRequest conversion;
  bool every_model = false;  ///< All models of each camera, one next to the others.
};

struct ReportResult {
  Status status = Status::kDone;  ///< Up to kRejected there is a report.
  Reading reading;
  std::vector<CheckResult> checks;  ///< Of each of its files.
  /// Without a format (ConvertResult::to): the cameras alone.
  std::optional<ConvertResult> conversion;
  std::vector<ModelsResult::OfCamera> models;
  /// Whether to use the written file or, without a conversion to a format, the files as they are: the worst of them.
  Verdict verdict;

  /// Of all that was done.
  [[nodiscard]] const Diagnostics& diagnostics() const { return conversion ? conversion->diagnostics : reading.diagnostics; }
};

[[nodiscard]] ReportResult report(const ReportRequest& request, Files& files);

}  // namespace fca
