// SPDX-License-Identifier: BSD-3-Clause
// What is said of every program.
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

      // ORB-SLAM3's KannalaBrandt8::unproject and cv::fisheye::undistortPoints: the distorted angle is cut off at pi / 2, and a
      // ray is K (x / z, y / z).
      clause(Code::kRaysUpToNinety, "from pixel to ray it goes no further than 90 deg, of the ray and of the distorted angle"),
      // cv::undistortPoints' default.
      clause(Code::kRaysInFiveSteps, "from pixel to ray it calls cv::undistortPoints, which stops after five steps"),
      clause(Code::kRaysWithoutAffine, "from pixel to ray it leaves out the affine part (ac, ad, ae)"),

      // Of the command's own parts: what for, and the loader's words.
      CodeInfo{.code = Code::kModuleMissing,
               .id = "module-missing",
               .severity = Severity::kError,
               .about = About::kUse,
               .text = "a part of the installation cannot be loaded, {0}: {1}"},
      clause(Code::kModuleOfAnotherBuild, "{0} was built with other sources than this command"),
      clause(Code::kModuleOfPrograms, "which asks the programs that use OpenCV's reader"),
      clause(Code::kModuleOfPictures, "which makes pictures"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
