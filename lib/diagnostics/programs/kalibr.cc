// SPDX-License-Identifier: BSD-3-Clause
// What Kalibr reports about a file. {0} is the key, where the sentence begins with one.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> kalibr_program_codes() {
  static constexpr std::array kRows = {
      named_refusal(Code::kKalibrSaysNotParsed, "Kalibr's PyYAML cannot read the file: {0}"),
      named_refusal(Code::kKalibrSaysFileNoMap, "the file is {0}; Kalibr wants a map"),
      named_refusal(Code::kKalibrSaysNoCamera, "the file has no camera; Kalibr wants cam0, cam1, ..."),
      named_refusal(Code::kKalibrSaysForeignKeys,
                    "Kalibr counts every top-level key as a camera ({0} here, with {1}) and stops because {2} is missing",
                    "remove everything that is not a camera from the top level"),
      clause(Code::kKalibrSaysFirstKey, "{0}"),
      clause(Code::kKalibrSaysNextKey, ", {0}"),
      named_refusal(Code::kKalibrSaysCameraNoMap, "{0} is {1}; Kalibr wants a map of the camera's keys"),
      named_refusal(Code::kKalibrSaysKeyMissing, "{0} is missing; Kalibr stops", kAddTheKey),
      named_refusal(Code::kKalibrSaysUnknownModel, "{0} is {1}; Kalibr knows pinhole, omni, eucm, ds"),
      named_refusal(Code::kKalibrSaysUnknownDistortion, "{0} is {1}; Kalibr knows radtan, equidistant, fov, none"),
      named_refusal(Code::kKalibrSaysNoSuchCamera, "{0}: Kalibr has no camera for {1} with {2}"),
      named_misreading(Code::kKalibrSaysPinholeWithNone,
                       "{0}: Kalibr stores pinhole with none under a wrong attribute name, so its calibrators fail later: "
                       "write radtan with four zeros"),
      named_refusal(Code::kKalibrSaysIntrinsicsCount, "{0} is {1}; Kalibr wants {2} for {3}"),
      named_refusal(Code::kKalibrSaysIntrinsicsType,
                    "{0} has {1} where {2} wants a number; Kalibr's Python raises a TypeError"),
      named_refusal(Code::kKalibrSaysNoFloat, "{0}: {1} is {2}; Kalibr wants a float and stops{3}"),
      clause(Code::kKalibrSaysFormOfFloats, ": PyYAML reads a number as a float only in the form 190.0 or 1.9e+02"),
      named_refusal(Code::kKalibrSaysNegative, "{0}: {1} is {2}; Kalibr refuses negative values"),
      named_refusal(Code::kKalibrSaysXiNegative, "{0}: xi is {1:.6f}; Kalibr wants xi >= 0 for omni"),
      named_refusal(Code::kKalibrSaysAlphaOutside, "{0}: alpha is {1:.6f}; Kalibr wants 0 <= alpha < 1 for {2}"),
      named_refusal(Code::kKalibrSaysBetaNegative, "{0}: beta is {1:.6f}; Kalibr wants beta >= 0"),
      named_refusal(Code::kKalibrSaysCoefficientCount, "{0} is {1}; Kalibr wants a list of {2} for {3}"),
      named_refusal(Code::kKalibrSaysCoefficientType,
                    "{0} has {1}; Kalibr wants numbers (PyYAML reads 1e-5 as a string: write 1.0e-05)"),
      named_misreading(Code::kKalibrSaysFovOutside,
                       "{0}: w is outside of 0.5 .. 1.5, where Kalibr regards its fov model as valid"),
      named_refusal(Code::kKalibrSaysResolutionNoInts,
                    "{0} must be two whole numbers [width, height] without a decimal point; Kalibr stops"),
      refusal(Code::kKalibrSaysResolutionTooLarge, "{0} is larger than an int"),
      named_misreading(Code::kKalibrSaysTopicMissing,
                       "{0} is missing; Kalibr stops when it looks for this camera's images in a bag", kAddTheKey),
      named_refusal(Code::kKalibrSaysTopicNoString, "{0} is {1}; Kalibr wants a string"),
      named_refusal(Code::kKalibrSaysOverlapsNoList, "{0} is {1}; Kalibr wants a list of camera numbers"),
      refusal(Code::kKalibrSaysOverlapsBeyond, "{0} names {1}, but the file has {2} camera(s), counted from 0"),
      named_refusal(Code::kKalibrSaysTimeshiftNoFloat, "{0} is {1}; Kalibr wants a float: write 0.0 or 1.0e-05, not 0 or 1e-5"),
      named_misreading(Code::kKalibrSaysBaselineMissing, "{0} is missing; Kalibr has no baseline from {1} to {2}", kAddTheKey),
      named_refusal(Code::kKalibrSaysPoseNoRows, "{0} must be four rows of four numbers; Kalibr stops{1}"),
      clause(Code::kKalibrSaysFormOfReals, " (1e-5 is a string for PyYAML: write 1.0e-05)"),
      named_refusal(Code::kKalibrSaysPoseFlat,
                    "{0} is one list of 16 numbers, as msckf_vio reads it; Kalibr wants four rows of four and stops"),
      named_refusal(Code::kKalibrSaysImuNested,
                    "the values are inside imu0: (Kalibr's result file); as an input Kalibr wants them at the top level"),
      named_refusal(Code::kKalibrSaysImuNoNumber,
                    "{0} is {1}; Kalibr wants a number (PyYAML reads 2e-5 as a string: write 2.0e-05)"),
      named_refusal(Code::kKalibrSaysImuNotPositive, "{0} is {1}; Kalibr wants more than 0 {2}"),
      named_refusal(Code::kKalibrSaysImuTopic, "{0} must be a string; Kalibr stops"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
