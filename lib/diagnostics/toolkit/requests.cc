// SPDX-License-Identifier: BSD-3-Clause
// What is said of the other requests, and of files that are saved.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kLimit = "error-limit";
constexpr std::string_view kNotWritten = "cannot-write";

}  // namespace

std::span<const CodeInfo> request_codes() {
  static constexpr std::array kRows = {
      error(Code::kNoInput, "no-input", "no file is given"),
      error(Code::kNoTarget, "no-target", "no format is given to write"),
      error(Code::kFileWithoutCamera, "no-camera", "{0} holds no camera"),

      // compare
      error(Code::kNothingCompared, kLimit, "{0}: no pixel could be compared"),
      error(Code::kDifferenceBeyondLimit, kLimit, "{0}: the worst pixel is off by {1:px} px, more than the limit of {2:px} px"),
      error(Code::kPixelsMissing, kLimit, "{0} has no pixel for {1:%} of the image", "if the lens ends before, say where{2}"),
      error(Code::kCamerasMissing, kLimit, "not every camera of the reference is there", "choose those to compare"),
      error(Code::kInversesBeyondLimit, kLimit,
            "the inverse polynomials differ by up to {0:px} px, more than the limit of {1:px} px"),
      error(Code::kMistakeFound, kLimit, "{0}"),
      error(Code::kPoseBeyondLimit, kLimit, "{0}, more than is alike (0.5 deg, and 5 mm or 5 % of the distance)"),
      error(Code::kFactBeyondLimit, kLimit, "{0}, more than is alike (1 ms for times, else 5 %)"),
      error(Code::kReferenceSaysMore, kLimit, "it does not say what the reference does: {0:and}"),
      clause(Code::kPoseDiffers, "T_{0}_{1} differs by {2:.3} deg and {3:.3} mm"),
      clause(Code::kTimeDiffers, "{0:_}{1} differs by {2:.3} ms"),
      clause(Code::kLengthDiffers, "{0:_}{1} differs by {2:.3} mm"),
      clause(Code::kRatioDiffers, "{0:_}{1} is {2:.3} times the reference's"),

      // remap
      error(Code::kNothingToRemap, "no-camera", "the file holds no camera"),
      bad_request(Code::kWhichCamera, "unknown-camera", "the file holds {0} cameras; which of them?", "choose one: {1}"),
      error(Code::kNoCameraInFile, "no-calibration", "the file holds no camera"),
      error(Code::kSeveralCameras, "unknown-camera", "the file holds {0} cameras; whose images are these?",
            "choose one camera"),
      error(Code::kFileWithoutSize, "no-size", "the file contains no image size", "give it"),
      error(Code::kCameraWithoutSize, "no-size", "{0} has no image size", "give a file that contains one"),
      error(Code::kImagesTooLarge, "image-size", "images of {0} x {1} px are too large to be remapped",
            "sides up to {2} px, and 134 megapixels"),
      error(Code::kViewOfSeveralCameras, "unknown-camera",
            "a view is like the only camera of a file, or like the one named {0}; this file has {1}"),

      // evaluate
      error(Code::kNotThePapersSize, "image-size", "the image is {0} x {1} px, and the paper's cameras are of {2:or}",
            "examples/cpp/render_image.cc makes one"),

      // What one format drops of another's, and makes up.
      clause(Code::kLedgerSeveralCameras, "several cameras in one file"),
      clause(Code::kLedgerPoses, "poses"),
      clause(Code::kLedgerImu, "IMU"),
      clause(Code::kLedgerTimeOffset, "time offset"),
      clause(Code::kLedgerFrameRate, "frame rate"),
      clause(Code::kLedgerTopics, "topics"),
      clause(Code::kLedgerBaseline, "baseline without poses"),
      clause(Code::kLedgerButPair, "{0} ({1}, but for a pair)"),
      clause(Code::kLedgerCamerasBeyond, "cameras beyond {0}"),
      clause(Code::kLedgerPosesButPair, "poses, but for a stereo pair"),
      clause(Code::kLedgerPosesInFrame, "poses in the frame {0}"),
      clause(Code::kLedgerNamed, "{0}"),
      clause(Code::kLedgerLengthUnit, "translation unit"),
      clause(Code::kLedgerSizeAsked, "nothing: the error asks for the image size"),

      // Files that are saved.
      error(Code::kNothingToSave, "nothing-to-save", "the conversion was not done: there are no files to write"),
      error(Code::kCannotOpen, kNotWritten, "cannot open {0}: {1}"),
      error(Code::kCannotWrite, kNotWritten, "cannot write {0}: {1}"),
      error(Code::kCannotCreateBeside, kNotWritten, "cannot create a file next to {0}: {1}"),
      error(Code::kCannotForceToDisk, kNotWritten, "cannot force the files to disk: {0}"),
      error(Code::kIsFolder, kNotWritten, "{0} is a directory"),
      error(Code::kFileExists, kNotWritten, "{0} exists"),
      error(Code::kFileProtected, kNotWritten, "{0} is write-protected",
            "make it writable (chmod u+w FILE), or name another file"),
      error(Code::kPathFails, kNotWritten, "{0}: {1}"),
      error(Code::kFolderMissing, kNotWritten, "cannot write {0}: there is no folder {1}"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
