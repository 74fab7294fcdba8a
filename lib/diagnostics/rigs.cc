// SPDX-License-Identifier: BSD-3-Clause
// Rigs and their images.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> rig_codes() {
  static constexpr std::array kRows = {
      bad_request(Code::kCropOutside, "crop-outside",
                  "the image of {0} x {1} px does not hold a region of {2} x {3} px at ({4}, {5})"),
      bad_request(Code::kBinningImpossible, "binning-impossible", "an image of {0} x {1} px has no bins of {2} x {2} px"),
      warning(Code::kImagesStretched, "images-stretched",
              "{0}: images of {1} x {2} px are stretched to {3} x {4}: {5:.3} times as much in width as in height",
              "right if a program scales both sides for itself; else say what was cut off first"),
      bad_request(Code::kResizeImpossible, "resize-impossible", "there is no image of {0} x {1} px"),
      error(Code::kImageSizeNotStated, "image-size-missing",
            "{0}: no input contains the size of the images that were calibrated", "give it"),
      warning(Code::kLensCircleStretched, "lens-circle-stretched",
              "{0}: in images stretched along one side the lens circle is none; the whole image counts"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
