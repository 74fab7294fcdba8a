// SPDX-License-Identifier: BSD-3-Clause
// Files that specify how uncertain a calibration is (formats/uncertainty).
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
      error(Code::kReportLineUnknown, "missing-key", "{0}: '{1}' is where {2} must be", "give the report as Kalibr wrote it"),
      error(Code::kReportBracketMissing, "not-a-list", "{0}: {1} is missing", "give the report as Kalibr wrote it"),
      error(Code::kReportUnknownGeometry, "unknown-model", "{0}: fca-io does not know the camera '{1}' of Kalibr"),
      error(Code::kReportTwice, "duplicate-key", "{0} appears twice"),
      error(Code::kReportNothing, "no-calibration", "the report contains no camera's numbers; it may be cut off",
            "give the report as Kalibr wrote it"),
      error(Code::kReportSigmaNegative, "out-of-range", "{0}: {1} is not a standard deviation"),
      error(Code::kUncertaintyOfOtherCamera, kOther, "it contains the uncertainty of {0}, but the calibration contains {1}",
            kGiveItsOwn),
      error(Code::kUncertaintyOfOtherModel, kOther, "{0} is {1} here, but {2} in the calibration", kGiveItsOwn),
      error(Code::kUncertaintyOfOtherValues, kOther,
            "{0} {1} is {2:.8} here, but {3:.8} in the calibration: {4:.3} standard deviations apart", kGiveItsOwn),
      error(Code::kCovarianceUnknownParameter, "model-contradicts", "'{0}' is not a parameter of {1} ({2})"),
      error(Code::kCovarianceNotSymmetric, "not-a-matrix",
            "row {0}, column {1} is {2}, but row {1}, column {0} is {3}: a covariance is symmetric"),
      error(Code::kCovarianceImpossible, "out-of-range",
            "{0}: the matrix is not a covariance: it gives a combination of parameters the variance {1:.3}"),
      error(Code::kCovarianceRowsMissing, "wrong-count", "{0}: {1} rows follow, but {2} are needed"),
      warning(Code::kOpencvSigmasOdd, "wrong-count",
              "{0}: OpenCV writes 18 standard deviations of its parameters, none below 0; these are not used"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
