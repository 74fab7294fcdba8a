// SPDX-License-Identifier: BSD-3-Clause
// Rigs and their images.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> rig_codes() {
  static constexpr std::array kRows = {
      bad_request(Code::kCropOutside, "crop-outside",
                  "the image of {0} x {1} px does not contain a region of {2} x {3} px at ({4}, {5})"),
      bad_request(Code::kBinningImpossible, "binning-impossible", "an image of {0} x {1} px has no bins of {2} x {2} px"),
      warning(Code::kImagesStretched, "images-stretched",
              "{0}: images of {1} x {2} px are stretched to {3} x {4}: {5:.3} times as much in width as in height",
              "this is right if a program scales both sides independently; otherwise also give the crop that came first"),
      bad_request(Code::kResizeImpossible, "resize-impossible", "an image cannot have {0} x {1} px"),
      error(Code::kImageSizeNotGiven, "image-size-missing",
            "{0}: no input contains the size of the images that were calibrated", "give the image size"),
      warning(Code::kLensCircleStretched, "lens-circle-stretched",
              "{0}: in images stretched along one side, the image circle is not a circle; the whole image counts"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
