// SPDX-License-Identifier: BSD-3-Clause
// What DSO reports about a camera.txt.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> dso_codes() {
  static constexpr std::array kRows = {
      refusal(Code::kDsoLineTooLong, "a line has more than 4096 characters; not read"),
      named_refusal(
          Code::kDsoUnknownLens,
          "line 1 is {0}; DSO wants RadTan, EquiDistant or KannalaBrandt with 8 numbers, FOV or Pinhole with 5, or the bare "
          "numbers (\"could not read calib file! exit.\")"),
      refusal(Code::kDsoNumberNotFinite, "a number of line 1 is not finite"),
      named_refusal(Code::kDsoSizeNotRead, "line {0} ({1} size) is {2}; DSO wants two whole numbers"),
      named_refusal(Code::kDsoOutputUnknown,
                    "line 3 is {0}; DSO wants exactly crop, full or none (no space, no CR after it), or five numbers"),
      named_refusal(Code::kDsoFullUnfinished, "line 3 is full, which DSO does not implement yet: assert(false)"),
      named_refusal(
          Code::kDsoSizesDiffer,
          "line 3 is none, but the sizes of the lines 2 and 4 differ; DSO exits (\"rectification mode none requires input "
          "and output dimenstions to match!\")"),
      misreading(Code::kDsoFifthNumberIgnored, "DSO reads the fifth number of Pinhole and ignores it: it is not a distortion"),
      misreading(Code::kDsoPixelsBelowOne,
                 "some of fx fy cx cy are below 1, but not both of cx and cy: DSO takes all four as pixels"),
      misreading(Code::kDsoSharesByCentre,
                 "cx and cy are below 1, so DSO also takes fx and fy as fractions of the image's width and height"),
      misreading(Code::kDsoOutputShares, "line 3 has a centre above 1; DSO takes the numbers as fractions of the output size"),
      misreading(Code::kDsoNotRectified,
                 "line 3 is none: DSO does not rectify and ignores the distortion of line 1, which costs up to {0:.3} px"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
