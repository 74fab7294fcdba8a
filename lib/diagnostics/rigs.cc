// SPDX-License-Identifier: BSD-3-Clause
// Rigs and their images.
#include "topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> rig_codes() {
  static constexpr std::array kRows = {
      CodeInfo{.code = Code::kCropOutside,
               .id = "crop-outside",
               .severity = Severity::kError,
               .about = About::kUse,
               .text = "the image of {0} x {1} px does not hold a region of {2} x {3} px at ({4}, {5})"},
      CodeInfo{.code = Code::kBinningImpossible,
               .id = "binning-impossible",
               .severity = Severity::kError,
               .about = About::kUse,
               .text = "an image of {0} x {1} px has no bins of {2} x {2} px"},
      CodeInfo{.code = Code::kResizeImpossible,
               .id = "resize-impossible",
               .severity = Severity::kError,
               .about = About::kUse,
               .text = "there is no image of {0} x {1} px"},
      CodeInfo{.code = Code::kImageSizeNotStated,
               .id = "image-size-missing",
               .severity = Severity::kError,
               .about = About::kMeaning,
               .text = "{0}: nothing states the size of the images that were calibrated",
               .fix = "state it"},
      CodeInfo{.code = Code::kLensCircleStretched,
               .id = "lens-circle-stretched",
               .severity = Severity::kWarning,
               .about = About::kMeaning,
               .text = "{0}: in images stretched along one side the lens circle is none; the whole image counts"},
  };
  return kRows;
}

}  // namespace fca::diagnostics
