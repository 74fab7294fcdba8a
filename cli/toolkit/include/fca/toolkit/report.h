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
  Inputs inputs;
  std::optional<ConvertRequest> conversion;  ///< What is shown of it; its inputs are those above.
  const ModelInfo* model = nullptr;          ///< Without a conversion: the cameras as this model, for no format.
  bool every_model = false;                  ///< All models of each camera, one beside the others.
  Objective objective = Objective::kRms;     ///< Of `model`.
  std::optional<int> degree;                 ///< Of `model`, if that is a polynomial.
  bool every_pixel = false;                  ///< As ConvertRequest's.
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
