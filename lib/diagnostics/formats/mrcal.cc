// SPDX-License-Identifier: BSD-3-Clause
// mrcal's camera models (formats/mrcal).
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> mrcal_codes() {
  static constexpr std::array kRows = {
      error(Code::kMrcalUnreadLens, "unknown-model", "{0} is '{1}', a lens of mrcal's own, which fca-io does not read",
            "mrcal-convert-lensmodel (sampled, intrinsics only) fits LENSMODEL_OPENCV8 to it, and prints by how many pixels it "
            "is off"),
      error(Code::kMrcalPosesDiffer, "poses-contradict", "{0} and {1} are different poses",
            "keep one of them, or write the same numbers under both"),
      loss(Code::kMrcalStale, "stale-derived", "{0} {1}",
           "mrcal computed it for the old lens, and it stays unchanged next to the new one",
           "remove it, or calibrate again with mrcal"),
      clause(Code::kMrcalPoseUnknown, "zeros: its pose in {0} is not in the input"),
      clause(Code::kMrcalDemandsSize, "mrcal needs an imagersize"),
      clause(Code::kMrcalNoTilt, "LENSMODEL_OPENCV12 has no tilted sensor"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
