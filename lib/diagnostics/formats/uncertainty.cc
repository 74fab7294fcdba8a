// SPDX-License-Identifier: BSD-3-Clause
// Files that state how uncertain a calibration is (formats/uncertainty).
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kOther = "other-calibration";
constexpr std::string_view kGiveItsOwn = "give the report that was written with the calibration";

}  // namespace

std::span<const CodeInfo> uncertainty_codes() {
  static constexpr std::array kRows = {
      error(Code::kReportLineUnknown, "missing-key", "{0}: '{1}' stands where {2} is wanted",
            "give the report as Kalibr wrote it"),
      error(Code::kReportBracketMissing, "not-a-list", "{0}: {1} is missing", "give the report as Kalibr wrote it"),
      error(Code::kReportUnknownGeometry, "unknown-model", "{0}: '{1}' is no camera of Kalibr's that fca-io knows"),
      error(Code::kReportTwice, "duplicate-key", "{0} comes twice"),
      error(Code::kReportNothing, "no-calibration", "the report contains no camera's numbers; it may be cut off",
            "give the report as Kalibr wrote it"),
      error(Code::kReportSigmaNegative, "out-of-range", "{0}: {1} is no standard deviation"),
      error(Code::kUncertaintyOfOtherCamera, kOther, "it contains the uncertainty of {0}; the calibration holds {1}",
            kGiveItsOwn),
      error(Code::kUncertaintyOfOtherModel, kOther, "{0} is {1} here and {2} in the calibration", kGiveItsOwn),
      error(Code::kUncertaintyOfOtherValues, kOther,
            "{0} {1} is {2:.8} here and {3:.8} in the calibration: {4:.3} standard deviations apart", kGiveItsOwn),
      error(Code::kCovarianceUnknownParameter, "model-contradicts", "'{0}' is no parameter of {1} ({2})"),
      error(Code::kCovarianceNotSymmetric, "not-a-matrix",
            "row {0}, column {1} is {2}, and row {1}, column {0} is {3}: a covariance is symmetric"),
      error(Code::kCovarianceImpossible, "out-of-range",
            "{0}: the matrix is no covariance: one of its combinations of parameters has the variance {1:.3}"),
      error(Code::kCovarianceRowsMissing, "wrong-count", "{0}: {1} rows follow, and {2} are wanted"),
      warning(Code::kOpencvSigmasOdd, "wrong-count",
              "{0}: the standard deviations of OpenCV's parameters are 18 numbers, none below 0; these are not used"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
