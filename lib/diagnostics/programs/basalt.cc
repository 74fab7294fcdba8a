// SPDX-License-Identifier: BSD-3-Clause
// What Basalt reports about a file. {0} is the key, where the sentence begins with one.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> basalt_program_codes() {
  static constexpr std::array kRows = {
      refusal(Code::kBasaltSaysNotParsed, "not JSON at byte {0}: {1}"),
      refusal(Code::kBasaltSaysFileNoObject, "the file is not a JSON object"),
      named_refusal(Code::kBasaltSaysMissing, "{0} is missing; Basalt stops", kAddTheKey),
      named_refusal(Code::kBasaltSaysNoObject, "{0} is not an object; Basalt stops"),
      named_refusal(Code::kBasaltSaysNoList, "{0} is not a list; Basalt stops"),
      named_refusal(Code::kBasaltSaysNoNumber, "{0} is not a number; Basalt stops"),
      named_refusal(Code::kBasaltSaysOneNumber, "{0} is one number; Basalt since 2020 wants a list of {1} and stops"),
      named_refusal(Code::kBasaltSaysListLength, "{0} is not a list of {1} numbers; Basalt stops"),
      named_refusal(Code::kBasaltSaysFewerItems, "{0} has fewer items than intrinsics: Basalt reads beyond its end"),
      refusal(Code::kBasaltSaysNoCamera, "{0} contains no camera"),
      named_refusal(Code::kBasaltSaysSizeNoInts, "{0} resolution is not a list of two ints; Basalt stops"),
      named_refusal(Code::kBasaltSaysUnknownType, "{0} is not a type that Basalt knows; it stops"),
      named_misreading(Code::kBasaltSaysQuaternionLength,
                       "{0}: the quaternion's length is not 1, and Basalt does not normalise it"),
      named_refusal(Code::kBasaltSaysTimeOffsetNoInt, "{0} is not an int; Basalt stops"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
