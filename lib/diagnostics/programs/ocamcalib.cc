// SPDX-License-Identifier: BSD-3-Clause
// What OCamCalib's reader reports about a file.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> ocamcalib_program_codes() {
  static constexpr std::array kRows = {
      refusal(Code::kOcamNotOpened, "the bytes cannot be opened as a file"),
      refusal(Code::kOcamCoefficientCount,
              "the {0} has {1} coefficients; the reader has places for 1 to 64 and does not check"),
      refusal(Code::kOcamLosesWay,
              "the reader takes {0} for the {1} and continues with garbage: it skips exactly one line before each block, and "
              "expects whole numbers as counts and sizes"),
      clause(Code::kOcamWords, "\"{0}\""),
      clause(Code::kOcamEndOfFile, "the end of the file"),
      clause(Code::kOcamNumberOfCoefficients, "number of coefficients of the {0}"),
      clause(Code::kOcamCoefficient, "coefficient {0} of the {1}"),
      refusal(Code::kOcamNotFinite, "a number of the model is not finite"),
      refusal(Code::kOcamSizeNotPositive, "the image size is not positive"),
      refusal(Code::kOcamAffineSingular, "[c d; e 1] is singular: cam2world divides by 0"),
      misreading(Code::kOcamOtherSign,
                 "a0 is positive: cam2world gives rays to the front, but OCamCalib's point to the back; the polynomial has the "
                 "wrong sign"),
      misreading(Code::kOcamCentreSwapped,
                 "the centre is read as (row, column), but is nearer to the middle of the image as (column, row): are they "
                 "swapped?"),
      misreading(Code::kOcamInverseFarOff,
                 "world2cam uses the file's inverse polynomial, which is up to {0:.3} px from the inverse of the direct one"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
