// SPDX-License-Identifier: BSD-3-Clause
// What Kalibr says to a file. {0} is the key, where the sentence begins with one.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> kalibr_program_codes() {
  static constexpr std::array kRows = {
      refusal(Code::kKalibrSaysNotParsed, "Kalibr's PyYAML cannot read the file: {0}"),
      refusal(Code::kKalibrSaysFileNoMap, "the file is {0}; Kalibr wants a map"),
      refusal(Code::kKalibrSaysNoCamera, "the file has no camera; Kalibr wants cam0, cam1, ..."),
      refusal(Code::kKalibrSaysForeignKeys,
              "Kalibr counts every top-level key as a camera ({0} here, with {1}) and stops because {2} is missing"),
      clause(Code::kKalibrSaysFirstKey, "{0}"),
      clause(Code::kKalibrSaysNextKey, ", {0}"),
      refusal(Code::kKalibrSaysCameraNoMap, "{0} is {1}; Kalibr wants a map of the camera's keys"),
      refusal(Code::kKalibrSaysKeyMissing, "{0} is missing; Kalibr stops"),
      refusal(Code::kKalibrSaysUnknownModel, "{0} is {1}; Kalibr knows pinhole, omni, eucm, ds"),
      refusal(Code::kKalibrSaysUnknownDistortion, "{0} is {1}; Kalibr knows radtan, equidistant, fov, none"),
      refusal(Code::kKalibrSaysNoSuchCamera, "{0}: Kalibr has no camera for {1} with {2}"),
      misreading(Code::kKalibrSaysPinholeWithNone,
                 "{0}: Kalibr builds pinhole with none under a wrong attribute name, so its calibrators fail later: write "
                 "radtan with four zeros"),
      refusal(Code::kKalibrSaysIntrinsicsCount, "{0} is {1}; Kalibr wants {2} for {3}"),
      refusal(Code::kKalibrSaysIntrinsicsType, "{0} has {1} where {2} wants a number; Kalibr's Python raises a TypeError"),
      refusal(Code::kKalibrSaysNoFloat, "{0}: {1} is {2}; Kalibr wants a float and stops{3}"),
      clause(Code::kKalibrSaysWriteAsFloat, ": write {0}.0"),
      clause(Code::kKalibrSaysFormOfFloats, ": PyYAML reads a number as a float only in the form 190.0 or 1.9e+02"),
      refusal(Code::kKalibrSaysNegative, "{0}: {1} is {2}; Kalibr refuses negative values"),
      refusal(Code::kKalibrSaysXiNegative, "{0}: xi is {1:.6f}; Kalibr wants xi >= 0 for omni"),
      refusal(Code::kKalibrSaysAlphaOutside, "{0}: alpha is {1:.6f}; Kalibr wants 0 <= alpha < 1 for {2}"),
      refusal(Code::kKalibrSaysBetaNegative, "{0}: beta is {1:.6f}; Kalibr wants beta >= 0"),
      refusal(Code::kKalibrSaysCoefficientCount, "{0} is {1}; Kalibr wants a list of {2} for {3}"),
      refusal(Code::kKalibrSaysCoefficientType,
              "{0} has {1}; Kalibr wants numbers (PyYAML reads 1e-5 as a string: write 1.0e-05)"),
      misreading(Code::kKalibrSaysFovOutside, "{0}: w is outside of 0.5 .. 1.5, where Kalibr regards its fov model as valid"),
      refusal(Code::kKalibrSaysResolutionNoInts, "{0} must be two ints [width, height]; Kalibr stops (512.0 is no int)"),
      refusal(Code::kKalibrSaysResolutionTooLarge, "{0} is larger than an int"),
      misreading(Code::kKalibrSaysTopicMissing, "{0} is missing; Kalibr stops when it looks for this camera's images in a bag"),
      refusal(Code::kKalibrSaysTopicNoString, "{0} is {1}; Kalibr wants a string"),
      refusal(Code::kKalibrSaysOverlapsNoList, "{0} is {1}; Kalibr wants a list of camera numbers"),
      refusal(Code::kKalibrSaysOverlapsBeyond, "{0} names {1}, but the file has {2} camera(s), counted from 0"),
      refusal(Code::kKalibrSaysTimeshiftNoFloat, "{0} is {1}; Kalibr wants a float: write 0.0 or 1.0e-05, not 0 or 1e-5"),
      misreading(Code::kKalibrSaysBaselineMissing, "{0} is missing; Kalibr has no baseline from {1} to {2}"),
      refusal(Code::kKalibrSaysPoseNoRows,
              "{0} must be four rows of four numbers; Kalibr stops (1e-5 is a string for PyYAML: write 1.0e-05)"),
      refusal(Code::kKalibrSaysImuNested,
              "the values are inside imu0: (Kalibr's result file); as an input Kalibr wants them at the top level"),
      refusal(Code::kKalibrSaysImuNoNumber, "{0} is {1}; Kalibr wants a number (PyYAML reads 2e-5 as a string: write 2.0e-05)"),
      refusal(Code::kKalibrSaysImuNotPositive, "{0} is {1}; Kalibr wants more than 0 {2}"),
      refusal(Code::kKalibrSaysImuTopic, "{0} must be a string; Kalibr stops"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
