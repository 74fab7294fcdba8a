// SPDX-License-Identifier: BSD-3-Clause
// What a check finds in a file's bytes, and of the programs that read it.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> file_check_codes() {
  static constexpr std::array kRows = {

      // The file.
      error(Code::kNamedPartMissing, "part-missing", "the file {0} cannot be read",
            "put the camera's file there, or name the right one (paths are relative to this file's folder)"),
      question(Code::kRestNotLookedAt, "wrong-syntax", "everything beyond the file's syntax",
               "the file could not be read as a calibration"),
      clause(Code::kExchangeNeighbours, "exchange it with {0} next to it"),
      clause(Code::kAsLensNoCamera, "; as {0}: no camera"),
      clause(Code::kAsLensNoSize, "; as {0}: field of view unknown without the image size"),
      clause(Code::kAsLensNoRay, "; as {0}: the image's border has no ray"),
      clause(Code::kAsLensView, "; as {0}: {1:.4} deg across the image"),
      clause(Code::kItsCost, "{0}."),

      // What was checked.
      clause(Code::kCheckedImage, "principal point, focal lengths and image size against each other"),
      clause(Code::kCheckedLens, "whether the lens model covers the image"),
      clause(Code::kCheckedFamily, "whether the numbers look like another model's"),
      clause(Code::kCheckedUndistortion, "whether cv::undistortPoints finds the right rays"),
      clause(Code::kCheckedRotations, "rotations"),
      clause(Code::kCheckedPoses, "poses that are given twice"),
      clause(Code::kCheckedDistances, "distances"),
      clause(Code::kCheckedImu, "IMU noise"),
      clause(Code::kCheckedTime, "time offsets"),
      clause(Code::kCheckedOcamcalib, "OCamCalib's two polynomials"),
      clause(Code::kCheckedOrbslam3, "ORB-SLAM3's baseline, depth threshold and matrix types"),
      clause(Code::kCheckedStella, "stella_vslam's focal length times baseline"),
      clause(Code::kCheckedProgram, "whether {0} loads the file"),

      // Programs, with what they say as a clause.
      refusal(Code::kProgramRefuses, "{0}{1} refuses the file: {2}"),
      refusal(Code::kProgramRefusesInItsWords, "{0}"),
      refusal(Code::kProgramRefusesMore, "{0} more refusals"),
      misreading(Code::kProgramMisreads, "{0}: {1}"),
      misreading(Code::kProgramMisreadsInItsWords, "{0}"),
      misreading(Code::kProgramMisreadsMore, "{0} more warnings"),
      about_reader(warning(Code::kProgramFindsNoCamera, "program-finds-no-camera", "{0}",
                           "rename the keys if OpenCV's sample programs should read the file")),
      about_reader(error(Code::kProgramOtherFormat, "program-other-format", "{1} cannot read the {0} format", "{2}")),
      question(Code::kProgramNoneAlone, "program-refuses", "whether a program loads the file",
               "no program that fca-io knows reads such a file alone"),
      with_consequence(about_reader(warning(Code::kReadByAnother, "program-refuses",
                                            "{0} can read the file, but {1} cannot: {2}{3}", "to get a file for {1}: {4}")),
                       "{1} does not start with it; {0} does."),
      about_reader(
          warning(Code::kModeRefused, "mode-refused", "the keys are for {0}, but {1} starts with them only as {2}: {3}{4}")),
      clause(Code::kInMode, " ({0})"),
      clause(Code::kAndMore, " (and {0} more)"),
      clause(Code::kConvertFor, "convert {0} to {1}{2}"),
      clause(Code::kConvertWithModel, ", with the model {0}"),
      clause(Code::kConvertWithLayout, ", in the layout {1}"),
      clause(Code::kConvertWithRewrite, ", as a fresh file"),
      clause(Code::kConvertWithSize, ", with the images' size"),
      clause(Code::kCorrectOrRewrite, "correct what the message names, or rewrite the file for the program: {0}"),
      clause(Code::kConvertToFile, ", into a {0} file"),
      clause(Code::kConvertToFiles, ", into a folder"),
      clause(Code::kConvertUnderName, ", under the name {0}"),
      clause(Code::kAddFileVersion, "add the line  File.version: \"1.0\""),
      clause(Code::kWhatNeedsItStops, "Programs that need it do not run."),
      error(Code::kMatrixNotFloat, "matrix-not-float", "{0} has dt: {1}, but ORB-SLAM3 reads its bytes as floats",
            "write dt: f"),

      // Fixes.
      remedy(Code::kSpellReal, "int-for-real", "write {0}"),
      remedy(Code::kSpellNumber, "number-as-text", "write {0}"),
      remedy(Code::kSpellWhole, "real-for-int", "write {0}"),
      remedy(Code::kSpellQuoted, "unquoted-text", "write {0}"),
      remedy(Code::kSpellRows, "wrong-length", "put each row of four numbers into brackets"),
      remedy(Code::kMarkRemoved, "byte-order-mark", "save the file as UTF-8 without a byte order mark (BOM)"),
      remedy(Code::kTabsToBlanks, "yaml-tab", "replace the TABs by spaces"),
      remedy(Code::kHeaderOfYaml, "opencv-header", "write {0}{1}"),
      clause(Code::kHeaderWithMark, "%YAML 1.2 and, in a line of its own, ---"),
      clause(Code::kHeaderWithoutMark, "%YAML 1.2"),
      clause(Code::kHeaderInFirstLine, " in the first line"),
      clause(Code::kBlanksAfterColons, "; and a space after every colon"),
      remedy(Code::kLayoutOfOpenCv, "yaml-layout", "{0}"),
      clause(Code::kLayoutWithoutMark, "remove the byte order mark (BOM) before the first line"),
      clause(Code::kLayoutBegins, "begin the file with {0}"),
      clause(Code::kLayoutIndented, "indent lists deeper than their key"),
      clause(Code::kLayoutThen, "; {0}"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
