// SPDX-License-Identifier: BSD-3-Clause
// What mrcal reports about a file. {0} is the key, where the sentence begins with one.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> mrcal_program_codes() {
  static constexpr std::array kRows = {
      named_misreading(Code::kMrcalSaysOnlyNewPose, "{0} is missing: mrcal before 2.5 does not know {1}, and stops",
                       "also write the numbers of {1} under {0}"),
      named_refusal(Code::kMrcalSaysPosesDiffer, "{0} and {1} differ; mrcal since 2.5 stops, and 2.4 reads {0}",
                    "write the same numbers under both"),
      named_misreading(Code::kMrcalSaysOtherLens, "{0} is {1}: fca-io does not compare its pixels with mrcal's"),
      named_refusal(Code::kMrcalSaysCoefficientCount, "{0} has {1} numbers; {2} has {3}, and mrcal stops"),
      named_refusal(Code::kMrcalSaysNoBytes, "{0} is not a string of bytes (b'..'); mrcal stops"),
      named_refusal(Code::kMrcalSaysNoCameraNumber, "{0} is not a whole number of at least 0; mrcal stops"),
      named_misreading(Code::kMrcalSaysNumberWithoutInputs, "{0} without optimization_inputs: mrcal since 2.5 stops",
                       "remove it"),
      named_misreading(Code::kMrcalSaysRegion, "{0} is not a closed contour of four points or more; mrcal skips it"),
      named_refusal(Code::kMrcalSaysSize, "{0} is not a list of two whole numbers above 0; mrcal stops"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
