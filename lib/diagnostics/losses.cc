// SPDX-License-Identifier: BSD-3-Clause
// What formats cannot hold. {0} is the owner (a camera, a file), {1} the key; the values follow.
#include "topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> loss_codes() {
  static constexpr std::array kRows = {
      CodeInfo{.code = Code::kTimeOffsetDropped,
               .id = "time-offset-dropped",
               .severity = Severity::kWarning,
               .about = About::kMeaning,
               .text = "{0} {1} {2:.12} s",
               .why = "{3}",
               .fix = "add {2:.12} s to every image time stamp of {0}"},
      CodeInfo{.code = Code::kTumviHasNoTimeOffset,
               .id = "time-offset-dropped",
               .severity = Severity::kWarning,
               .about = About::kReader,
               .text = "TUM-VI's chains have none: the dataset's offsets are removed from its time stamps"},
      CodeInfo{.code = Code::kTumviPoseRecomputed,
               .id = "pose-recomputed",
               .severity = Severity::kWarning,
               .about = About::kMeaning,
               .text = "{0} {1}",
               .why =
                   "as stated it differs from T_cn_cnm1 times the pose of {2} by up to {3:.3} in an element, and TUM-VI's two "
                   "statements agree",
               .fix = "check which of them is right"},
      CodeInfo{.code = Code::kWoodscapeStaleTranslation,
               .id = "stale-derived",
               .severity = Severity::kWarning,
               .about = About::kMeaning,
               .text = "extrinsic.{1}",
               .why = "it is kept as it was, and the pose beside it is another one",
               .fix = "remove it, or write the new pose's"},
  };
  return kRows;
}

}  // namespace fca::diagnostics
