// SPDX-License-Identifier: BSD-3-Clause
// What WoodScape's readers report about a file: Python, projection.py and omnidet. Where {0} is a path, "intrinsic.k1", it is
// first.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> woodscape_program_codes() {
  static constexpr std::array kRows = {
      refusal(Code::kPythonJsonBom, "the file begins with a BOM: JSONDecodeError, Unexpected UTF-8 BOM"),
      refusal(Code::kPythonJsonZeroByte, "the file contains a zero byte: JSONDecodeError"),
      refusal(Code::kPythonJsonTooDeep, "lists within lists, more than 900: RecursionError"),
      refusal(Code::kPythonJsonNotParsed, "JSONDecodeError at byte {0}: {1}"),
      refusal(Code::kPythonJsonNoObject, "the file is not a JSON object: TypeError"),
      refusal(Code::kPythonKeyMissing, "{0} is missing: KeyError '{1}'{2}", kAddTheKey),
      clause(Code::kPythonSimilarKey, " (there is \"{0}\")"),
      refusal(Code::kPythonNotAnObject, "{0} is not an object: TypeError"),
      refusal(Code::kPythonNotANumber, "{0} is not a number"),
      refusal(Code::kPythonNotNumbers, "{0} is not a list of {1} numbers: ValueError"),

      refusal(Code::kProjectionPySizeNotInt, "the image size is not an int: ValueError, or no picture"),
      misreading(Code::kProjectionPySizeNotPositive, "the image size is not positive: clipping raises RuntimeError"),
      misreading(Code::kProjectionPyIgnores, "{0} is ignored: only k1 to k4 are read"),
      misreading(Code::kProjectionPyNormalised,
                 "{0} is below 10: projection.py reads it as pixels per radian, but it looks normalised"),
      misreading(Code::kProjectionPyOtherModel,
                 "{0} is not \"radial_poly\"; projection.py does not look at it, and reads the numbers as radial_poly"),
      refusal(Code::kProjectionPyNoRotation, "{0} is zero or not finite: ValueError"),

      refusal(Code::kOmnidetNameMissing, "{0} is missing: KeyError '{0}' in generate_luts.py", kAddTheKey),
      refusal(Code::kOmnidetTooFewValues, "{0} has {1} values; omnidet takes 8 by their place"),
      refusal(Code::kOmnidetValueNoNumber,
              "the value at place {1} of {0} is \"{2}\", which is not a number; omnidet takes it for {3}"),
      misreading(Code::kOmnidetWidthNotLast,
                 "{0} does not end with width at place 10; generate_luts.py takes the last value for it"),
      misreading(Code::kOmnidetOtherOrder,
                 "omnidet takes the value at place {1} of {0}, \"{2}\", for {3}: the keys must be in WoodScape's order"),
      misreading(Code::kOmnidetOtherSize,
                 "the image is not 1280 x 966, but omnidet assumes that size whatever the file contains"),
      misreading(Code::kOmnidetCentre, "omnidet's centre is width / 2 + cx_offset, without the - 0.5 of projection.py: {0}"),
      clause(Code::kOmnidetCost, "in all up to {0:.3} px"),
      clause(Code::kOmnidetNotComparable, "not comparable, because {0} is not a number"),
      misreading(Code::kOmnidetAspectRatio,
                 "generate_luts.py divides both coordinates by aspect_ratio, where the projection multiplies only v"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
