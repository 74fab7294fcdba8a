// SPDX-License-Identifier: BSD-3-Clause
// What VINS-Fusion reports about a file: little. {0} is the key, where the sentence begins with one.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> vins_program_codes() {
  static constexpr std::array kRows = {
      refusal(Code::kVinsSaysMissing, "{0} is missing: VINS reads 0 without a warning", kAddTheKey),
      refusal(Code::kVinsSaysNoNumber, "{0} is {1}, not a number: VINS reads 1.8e308"),
      refusal(Code::kVinsSaysSizeMissing, "{0} is missing: VINS reads 0", kAddTheKey),
      refusal(Code::kVinsSaysNoModel, "{0} is missing: VINS takes the camera for MEI, and reads 0 for every missing number",
              kAddTheKey),
      refusal(Code::kVinsSaysModelCase, "{0} is {1}, not {2}: VINS then reads every number as 0 without a warning"),
      refusal(Code::kVinsSaysUnknownModel, "{0} is \"{1}\": VINS knows no such model and stops"),
      misreading(Code::kVinsSaysFullOfZeros,
                 "k1, k2, p1 and p2 are 0: PINHOLE_FULL is then taken for a lens without distortion, whatever k3 to k6 are"),
      refusal(Code::kVinsSaysInverseMissing, "{0} is missing: VINS projects every point to the centre", kAddTheKey),
      misreading(Code::kVinsSaysInverseOff,
                 "points are projected with inv_poly_parameters, which is up to {0:.3} px from the inverse of poly_parameters"),
      refusal(Code::kVinsSaysAffineSingular, "[ac ad; ae 1] is singular: liftProjective divides by 0"),
      misreading(Code::kVinsSaysAffineForgotten,
                 "liftProjective ignores the affine part: the rays of scaramuzza's pixels are turned by about |ac - 1|, |ad| "
                 "and |ae| rad"),
      misreading(Code::kVinsSaysNoPixelOnAxis, "a point exactly on the axis has no pixel in scaramuzza (0 / 0)"),
      // The main configuration.
      named_refusal(Code::kVinsSaysCameraCount, "{0} is {1}, not 1 or 2: VINS-Fusion stops"),
      named_refusal(Code::kVinsSaysCameraMissing, "{0} is missing: VINS-Fusion has no camera and stops", kAddTheKey),
      named_refusal(Code::kVinsSaysPoseMissing, "{0} is missing: VINS-Fusion copies a matrix that is not there", kAddTheKey),
      named_refusal(Code::kVinsSaysPoseSize, "{0} is not 4 x 4: VINS-Fusion copies it unchecked"),
      misreading(Code::kVinsSaysZero, "VINS-Fusion takes as 0 what is 0 or missing: {0:and}"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
