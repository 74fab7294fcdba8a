// SPDX-License-Identifier: BSD-3-Clause
// Values under the keys of a file, in every format. {0} is as a rule what the value is called.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kTwice = "duplicate-key";
constexpr std::string_view kNoInteger = "not-an-integer";
constexpr std::string_view kNoString = "not-a-string";
constexpr std::string_view kLength = "wrong-length";
constexpr std::string_view kRange = "out-of-range";
constexpr std::string_view kNoRotation = "not-a-rotation";
constexpr std::string_view kUnprintable = "name-unprintable";
constexpr std::string_view kPrintableName = "give it a name of printable characters";

}  // namespace

std::span<const CodeInfo> field_codes() {
  static constexpr std::array kRows = {
      reader_warning(Code::kYamlDirectiveMissing, "program-refuses",
                     "the first line is not %YAML; cv::FileStorage does not open the file", "begin the file with  %YAML:1.0"),
      note(Code::kKeyTwiceAlike, kTwice, "the key {0} appears twice, with the same value"),
      warning(Code::kKeyTwiceUnlike, kTwice, "the key {0} appears twice, with {1} and here with {2}, which is not read"),
      warning(Code::kKeyTwice, kTwice, "the key {0} appears twice; this one is not read"),
      warning(Code::kMoreKeysTwice, kTwice, "{0} more keys appear twice and are not read"),
      warning(Code::kKeyMisspelt, "key-misspelt", "'{0}' is not read, and there is no {1}", "did you mean {1}?"),
      error(Code::kKeyMissing, "missing-key", "{0} has no {1}"),

      // What stands in a value's place.
      clause(Code::kValueEmpty, "empty"),
      clause(Code::kValueText, "'{0}'"),
      clause(Code::kValueList, "a list"),
      clause(Code::kValueMapping, "a mapping"),

      // Numbers and names.
      warning(Code::kValueOctal, "octal", "{0} is written '{1}', which the programs read as octal {2}"),
      error(Code::kValueNoNumber, "not-a-number", "{0} is {1}; it must be a number"),
      error(Code::kValueNotFinite, "not-finite", "{0} is '{1}', not a finite number"),
      error(Code::kValueNotPositive, "not-positive", "{0} is '{1}'; it must be greater than 0{2}"),
      clause(Code::kAndTooLarge, " and is too large"),
      error(Code::kValueNoInteger, kNoInteger, "{0} is {1}; it must be a whole number{2}"),
      clause(Code::kOf32Bits, " of 32 bits"),
      error(Code::kValueNoName, kNoString, "{0} is {1}; it must be a name"),
      warning(Code::kValueNoNameUnread, kNoString, "{0} is {1}; it must be a name, and is not read"),
      warning(Code::kNameReadAs, kUnprintable,
              "{0} holds line breaks, control characters or bytes that are not UTF-8; it is read as '{1}'", kPrintableName),
      error(Code::kValueNoList, "not-a-list", "{0} is {1}; it must be a list of numbers"),
      error(Code::kNumbersWanted, kLength, "{0} has {1} numbers; it must have {2}"),
      error(Code::kRowsWanted, kLength, "{0} has {1} rows; it must have {2}"),

      // Numbers that cannot be; {1} says why.
      error(Code::kBaselineOutOfRange, kRange, "{0}: {1}", "write the distance of the two cameras in metres"),
      error(Code::kBaselineTimesFocalLength, kRange, "{0}: {1}",
            "write the distance of the two cameras in metres, times the focal length in pixels"),
      error(Code::kTimeOffsetOutOfRange, kRange, "{0}: {1}", "write it in seconds: t_imu = t_cam + offset"),
      error(Code::kTranslationOutOfRange, kRange, "{0}: {1}", "write translations in metres"),
      error(Code::kLastRowWrong, "not-a-transform", "{0}: the last row of a transform is 0 0 0 1"),
      error(Code::kRotationImpossible, kNoRotation, "{0}: {1}",
            "the columns of a rotation are unit vectors at right angles to each other"),
      warning(Code::kRotationRough, kNoRotation, "{0}: {1}"),
      warning(Code::kRotationMirrors, kNoRotation, "{0}: its 3 x 3 part is a mirror image, not a rotation"),
      error(Code::kValueNoMatrix, "not-a-matrix", "{0} is {1}; it must be an opencv-matrix"),
      error(Code::kMatrixOfSize, kLength, "{0}: a matrix of {1} x {2}"),

      // What must not be written.
      error(Code::kNameUnprintable, kUnprintable, "{0} '{1}' holds line breaks, control characters or bytes that are not UTF-8",
            kPrintableName),
      clause(Code::kTheCamera, "the camera"),
      clause(Code::kTheImu, "the IMU"),
      clause(Code::kTheTopic, "the topic"),
      error(Code::kPoseMirrors, "left-handed", "T_{0}_{1} mirrors (its determinant is -1): no program can use it",
            "fix the sign or the order of its rows first"),
      error(Code::kNumberWouldNotBeFinite, "not-finite", "{0} would not be a finite number in {1}"),
      clause(Code::kNumberWithoutName, "a number"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
