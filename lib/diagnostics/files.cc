// SPDX-License-Identifier: BSD-3-Clause
// Files and formats, whichever.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kUnreadable = "cannot-read";
constexpr std::string_view kUnknown = "unknown-format";
constexpr std::string_view kSayWhichFormat = "say which format it is, if it is one of those that are listed";
constexpr std::string_view kStatedTwice = "stated-twice";
constexpr std::string_view kContradict = "poses-contradict";

}  // namespace

std::span<const CodeInfo> file_codes() {
  static constexpr std::array kRows = {
      // Why a file is of a format.
      clause(Code::kFormatTold, "as told"),
      clause(Code::kFoundKey, "the key {0}"),
      clause(Code::kFoundKeys, "{0}"),
      clause(Code::kFoundTopLevel, "top-level {0}"),
      clause(Code::kFoundMatrices, "{0} with rows, cols and data"),
      clause(Code::kFoundIniSections, "sections of an .ini"),

      error(Code::kFileUnreadable, kUnreadable, "cannot read the file: {0}"),
      clause(Code::kFileMissing, "it does not exist"),
      clause(Code::kFileIsDirectory, "it is a directory"),
      clause(Code::kFileReadingFailed, "reading failed"),
      error(Code::kFileTooLarge, "too-large", "larger than {0} MiB; no calibration is"),
      error(Code::kFileEmpty, "empty-file", "the file is empty"),
      error(Code::kFileBinary, "binary-file", "a zero byte: this is no text file", "save it as UTF-8 text"),
      error(Code::kFileUtf16, "utf-16", "the file is UTF-16 text; programs read calibrations as UTF-8",
            "save it as UTF-8: iconv -f UTF-16 -t UTF-8 FILE > NEW"),
      error(Code::kFileCrOnly, "cr-line-ends",
            "its lines end in CR alone: to OpenCV's reader and OCamCalib's the file is one line",
            "end them in LF: tr '\\r' '\\n' < FILE > NEW"),

      error(Code::kFormatUnknown, kUnknown, "none of the formats fca-io reads: no key of it stands here", kSayWhichFormat),
      // {0}: a clause, {1} and {2}: keys.
      error(Code::kFormatLooksLikeKeysBeside, kUnknown, "looks like {0} ({1} and {2}), which fca-io does not read",
            kSayWhichFormat),
      error(Code::kFormatLooksLikeKeysInside, kUnknown, "looks like {0} ({1} with {2}), which fca-io does not read",
            kSayWhichFormat),
      clause(Code::kLooksLikeMultiCol, "MultiCol-SLAM's OCam settings"),
      clause(Code::kLooksLikeOv2Slam, "OV2SLAM's settings"),
      clause(Code::kLooksLikeD2Slam, "D2SLAM's settings"),
      clause(Code::kLooksLikePlainLists, "OpenCV's numbers in plain lists, of which cv::FileStorage makes no matrix"),
      clause(Code::kLooksLikePyOcamCalib, "py-OCamCalib's JSON"),
      error(Code::kFormatAmbiguous, "ambiguous-format", "could be {0:or}", "say which format it is"),
      clause(Code::kFormatCandidate, "{0} ({1})"),

      error(Code::kTooManyCameras, "too-many-cameras", "{0} cameras; fca-io reads at most {1} of one rig", "split the file"),
      error(Code::kCameraInMainFile, kStatedTwice, "a camera {0} stands here and in the main file"),
      error(Code::kImuInMainFile, kStatedTwice, "an IMU {0} stands here and in the main file, with other numbers"),
      // {0} and {1}: frames, {3}: the largest difference.
      warning(Code::kPoseInTwoFiles, kContradict,
              "T_{0}_{1} is stated here and in {2}, and the two differ by up to {3:.3} in an element",
              "that of {4} is used; take out the one that is wrong"),
      warning(Code::kPoseContradictsOthers, kContradict,
              "T_{0}_{1} as stated and as it follows from the other poses ({2}) differ by {3:.3} deg and {4}",
              "one of them is wrong; stated poses are used before derived ones"),
      warning(Code::kPoseOfEachUnstated, "pose-unstated",
              "the files of {0} say the same place for each, as a camera's alone does: how they sit to each other is not "
              "known"),

      // {0}: a camera.
      bad_request(Code::kFormatHasNoModel, "model-not-storable", "{0}: {1} has no {2} model",
                  "convert the camera to a model of this format first"),
      bad_request(Code::kFormatHasNoValue, "parameter-not-storable",
                  "{0}: {1} = {2} cannot be stored as {3} ({4}); it must lie in [{5}, {6}]",
                  "convert the camera to this format's ranges first"),
      bad_request(Code::kFormatNeedsCamera, "no-camera", "{0}: this format needs a camera, and the input has none"),
      error(Code::kFormatNeedsSize, "image-size-missing", "{0}: {1} and the input has no size", "state it"),
      error(Code::kNotWrittenBecause, "not-written", "{0} cannot be written: {1}"),

      // {0}: a key.
      bad_request(Code::kSetWrongType, "set-wrong-type", "{0} wants {1}, not '{2}'"),
      bad_request(Code::kSetOutOfRange, "set-out-of-range", "{0} wants {1}, not {2}"),
      bad_request(Code::kSetNoSingleValue, "set-unknown-key", "single values can be set, and '{0}' is {1}",
                  "change the input where it is a part of the calibration"),
      bad_request(Code::kSetUnknownKey, "set-unknown-key", "the file written has no value under '{0}'{1}"),
      clause(Code::kSetDidYouMean, "; did you mean {0:or}?"),
      bad_request(Code::kSetLayout, "set-contradicts", "{0} is how the file states its calibration, which would be lost",
                  "leave it"),
      bad_request(Code::kSetCalibration, "set-contradicts", "{0} is a part of the calibration, which says otherwise",
                  "change the input; images of another size are asked for as such"),
      clause(Code::kWantsFiniteNumber, "a number that a double can hold"),
      clause(Code::kWantsWholeNumber, "a whole number"),
      clause(Code::kWantsNumber, "a number"),
      clause(Code::kWantsWord, "a word"),
      clause(Code::kWantsPlainWord, "a word of letters, digits and ._-+/~"),
      clause(Code::kWantsPlainText, "letters, digits and ._-+/~ only"),
      clause(Code::kWantsNumberAboveZero, "a number above 0"),
      clause(Code::kWantsNumberBetween, "a number from {0} to {1}"),
      clause(Code::kValueIsGroup, "a group of values"),
      clause(Code::kIdentity, "identity"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
