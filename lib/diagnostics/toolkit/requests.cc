// SPDX-License-Identifier: BSD-3-Clause
// Messages about the other requests and about saved files.
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
      error(Code::kPixelsMissing, kLimit, "{0} has no pixel for {1:%} of the image",
            "if the lens ends earlier, give the angle{2}"),
      error(Code::kCamerasMissing, kLimit, "a camera of the reference is missing", "choose those to compare"),
      error(Code::kInversesBeyondLimit, kLimit,
            "the inverse polynomials differ by up to {0:px} px, more than the limit of {1:px} px"),
      error(Code::kMistakeFound, kLimit, "{0}"),
      error(Code::kPoseBeyondLimit, kLimit, "{0}, more than the tolerance (0.5 deg, and 5 mm or 5 % of the distance)"),
      error(Code::kFactBeyondLimit, kLimit, "{0}, more than the tolerance (1 ms for times, else 5 %)"),
      error(Code::kReferenceSaysMore, kLimit, "the file lacks something that the reference contains: {0:and}"),
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
      error(Code::kFileWithoutSize, "no-size", "the file contains no image size", "give the image size"),
      error(Code::kCameraWithoutSize, "no-size", "{0} has no image size", "give a file that contains one"),
      error(Code::kImagesTooLarge, "image-size", "images of {0} x {1} px are too large to be remapped",
            "sides up to {2} px, and 134 megapixels"),
      error(Code::kViewOfSeveralCameras, "unknown-camera",
            "the file for a view must have one camera, or one named {0}; this file has {1}"),

      // rectify
      error(Code::kRectifyNeedsPair, "no-pair", "a stereo pair has two cameras, but the file contains {0}",
            "also give the file of the other camera"),
      error(Code::kRectifyNoPose, "pose-missing", "no input contains the pose between {0} and {1}",
            "also give a file that contains it"),
      error(Code::kRectifySizesDiffer, "image-size",
            "images of {0} are {1} x {2} px and those of {3} are {4} x {5} px; a pair must have one size",
            "give cameras with one image size"),
      error(Code::kRectifyNothingShared, "nothing-in-common",
            "{0} and {1} see nothing in common: their axes are {2:.3} deg apart",
            "choose two cameras that look in the same direction"),
      error(Code::kRectifyWhichPair, "no-pair", "no two of the {0} cameras are known to share a quarter of their images",
            "choose the two"),
      error(Code::kRectifyNoBaseline, "no-baseline", "{0} and {1} are at the same place: there is no disparity",
            "check the translation of their pose"),
      bad_request(Code::kRectifyViewTooWide, "view-too-wide",
                  "the view would be {0:.4} deg wide, and 120 deg is the most: {1:%} of it would be stretched more than four "
                  "times",
                  "ask for a narrower view: 100 deg or less"),
      error(Code::kRectifyNoValidPart, "nothing-in-common", "{0} does not cover any part of the rectified image completely",
            "check the pose, or ask for a wider view"),
      bad_request(Code::kRectifyNoPlace, "option-without-use",
                  "{0} has no place for a rectified pair; these formats have: {1:or}"),
      error(Code::kRectifyVertical, "pair-vertical", "{0} and {1} are above each other, but {2} looks for matches along rows",
            "turn the images by 90 deg before the calibration, or write an OpenCV file"),
      error(Code::kRectifyCentresDiffer, "rectified-centres-differ",
            "the rectified images have cx {0:.6} and {1:.6} px, but {2} takes only one cx", "compute another view"),
      error(Code::kRectifyModelNotKnown, "model-not-storable", "{0} rectifies images itself, but does not know the model {1}",
            "write settings of rectified images"),
      error(Code::kRectifyOpencvFailed, "no-rectification", "OpenCV cannot rectify this pair: {0}"),
      warning(Code::kRectificationOfOtherImages, "stale-derived",
              "the rectification in the file is for other images, and is left out", "compute another one"),

      // evaluate
      error(Code::kNotThePapersSize, "image-size", "the image is {0} x {1} px, but the paper's cameras have {2:or}",
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
      error(Code::kCannotCreateNextTo, kNotWritten, "cannot create a file next to {0}: {1}"),
      error(Code::kCannotForceToDisk, kNotWritten, "cannot flush the files to the disk: {0}"),
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
