// SPDX-License-Identifier: BSD-3-Clause
// Collects the contents of a report on a calibration: the calibration itself, the findings of its check, and its conversion.
#pragma once

#include <fca/toolkit/check.h>
#include <fca/toolkit/convert.h>
#include <fca/toolkit/models.h>
#include <fca/toolkit/read.h>

#include <optional>
#include <vector>

namespace fca {

struct ReportRequest {
  /// The inputs of the report, and the conversion that it describes. If neither `to` nor `into` is set, no file is made: the
  /// cameras are only fitted to `model`. If that is null, too, nothing is converted.
  ConvertRequest conversion;
  bool every_model = false;  ///< Also fit every model to each camera.
};

struct ReportResult {
  Status status = Status::kDone;  ///< The report is complete if this is kDone or kRejected.
  Reading reading;
  std::vector<CheckResult> checks;  ///< One for each file of the calibration.
  /// The conversion, if the request has one. It contains only cameras if ConvertResult::to is null.
  std::optional<ConvertResult> conversion;
  std::vector<ModelsResult::OfCamera> models;  ///< One for each camera if the request asks for every model.
  /// Whether to use the converted files. Without a conversion to a format: whether to use the input files, by the worst of
  /// them.
  Verdict verdict;

  /// The diagnostics of the conversion if there is one, otherwise those of reading.
  [[nodiscard]] const Diagnostics& diagnostics() const { return conversion ? conversion->diagnostics : reading.diagnostics; }
};

/// Reads, checks and converts the inputs of a request.
[[nodiscard]] ReportResult report(const ReportRequest& request, Files& files);

}  // namespace fca
