// SPDX-License-Identifier: BSD-3-Clause
// Messages about every program.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> proof_codes() {
  static constexpr std::array kRows = {

      // {0} the mode; what it says is the last argument, here and below.
      misreading(Code::kProgramAsMode, "as {0}: {1}"),
      refusal(Code::kProgramWouldMisread, "it would load the file and misread it: {0}"),
      misreading(Code::kProgramMisreadsAll, "it misreads every camera: {0}"),
      clause(Code::kProgramOtherModel, "another model"),
      refusal(Code::kProgramSays, "{0}: {1}"),
      // {0} the owner, which may be empty; then the program's number, and the rig's.
      misreading(Code::kProgramOtherNumber, "{0:_}{1} is {2:.9}, not {3:.9}"),

      // {0} the key; the last argument is the program, if its words are not a list.
      named_refusal(Code::kProgramSaysMissing, "{0} is missing; {1} stops", kAddTheKey),
      named_refusal(Code::kProgramSaysNoText, "{0} is empty or not text; {1} stops"),
      named_refusal(Code::kProgramSaysNoNumber, "{0} is {1}, not a number; {2} stops"),
      named_refusal(Code::kProgramSaysNoReal, "{0} is {1}; {2} wants a number with a point, and stops"),
      named_refusal(Code::kProgramSaysNumberCount, "{0} is not a list of {1} numbers; {2} stops"),
      named_refusal(Code::kProgramSaysUnknownWord, "{0} is {1}; {2} knows only {3:and}, and stops"),
      named_refusal(Code::kProgramSaysLeavesCameraOut, "{0} is {1}; {2} knows only {3:and}, and ignores the camera"),
      named_refusal(Code::kProgramSaysNoId, "{0} is {1}; {2} wants 32 hexadecimal digits, and stops"),
      named_refusal(Code::kProgramSaysSameId, "{0} is {1}, which another sensor has, too; {2} stops"),
      named_refusal(Code::kProgramSaysOutOfRange, "{0} is {1}; {2} takes {3} to {4}, and stops"),
      named_misreading(Code::kProgramSaysUnread, "{1} does not read {0}"),
      // Of the file. {0}: what parses it, {1}: its words.
      refusal(Code::kProgramSaysNotParsed, "{0} cannot read it: {1}"),
      refusal(Code::kProgramSaysNoKeys, "the file holds no keys"),

      // ORB-SLAM3's KannalaBrandt8::unproject and cv::fisheye::undistortPoints: the distorted angle is cut off at pi / 2, and a
      // ray is K (x / z, y / z).
      clause(Code::kRaysUpToNinety, "from pixel to ray it stops at 90 deg from the axis, and at a distorted angle of 90 deg"),
      // cv::undistortPoints' default.
      clause(Code::kRaysInFiveSteps, "from pixel to ray it calls cv::undistortPoints, which stops after five steps"),
      clause(Code::kRaysInFiveOwnSteps, "from pixel to ray it stops after five steps"),
      clause(Code::kRaysWithoutAffine, "from pixel to ray it ignores the affine part (ac, ad, ae)"),

      // Of the command's own parts: what for, and the loader's words.
      CodeInfo{.code = Code::kModuleMissing,
               .id = "module-missing",
               .severity = Severity::kError,
               .about = About::kUse,
               .text = "a part of fca-io, {0}, cannot be loaded: {1}"},
      clause(Code::kModuleOfAnotherBuild, "{0} was built from other sources than this command"),
      clause(Code::kModuleOfPrograms, "which imitates the programs that use OpenCV's reader"),
      clause(Code::kModuleOfPictures, "which makes pictures"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
