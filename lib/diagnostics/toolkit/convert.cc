// SPDX-License-Identifier: BSD-3-Clause
// Messages about a conversion as requested.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kNoOtherLayout = "into-another-layout";
constexpr std::string_view kLimit = "error-limit";
constexpr std::string_view kUseless = "option-without-use";

}  // namespace

std::span<const CodeInfo> convert_codes() {
  static constexpr std::array kRows = {
      // The request.
      bad_request(Code::kModeWithoutUse, kUseless, "a mode is for files for {0:or}, not {1}"),
      bad_request(Code::kRateWithoutUse, kUseless, "a frame rate is for files for {0:or}, not {1}"),
      bad_request(Code::kBaselineWithoutUse, kUseless, "a baseline is for files for {0:or}, not {1}"),
      bad_request(Code::kArgumentsWithoutUse, kUseless, "arguments of a command line are for {0:or}, not {1}"),
      bad_request(Code::kDegreeWithoutUse, kUseless, "a degree is for files for {0:or}, not {1}"),
      bad_request(Code::kLayoutWithoutUse, kUseless, "a layout of {0} is for files for {0}, not {1}"),
      error(Code::kNothingToConvert, "no-camera", "the file holds {0}",
            "give it together with the file that contains the cameras"),
      clause(Code::kImuAndNoCamera, "an IMU and no camera"),
      clause(Code::kPoseAndNoCamera, "{0} pose{0:s} and no camera"),
      clause(Code::kNoCameraAtAll, "no camera"),
      clause(Code::kAsFormat, "as {0}"),
      clause(Code::kIntoFile, "into {0}"),
      bad_request(
          Code::kBaselineOfSeveral, "baseline-contradicts",
          "a baseline is for one camera of a rectified pair or depth sensor, but these are {0} cameras with poses of their own",
          "choose one camera"),
      error(Code::kImuIsAnother, "imu-without-pose", "the cameras' poses refer to {0}, but the given IMU is {1}",
            "give the file of {0}'s noise, or rename {1} if it is the same IMU"),
      bad_request(Code::kModelNotStorable, "model-not-storable", "{0} cannot hold {1}; it holds {2}"),
      bad_request(Code::kSettingContradictsRate, "set-contradicts",
                  "{0} = {1} and the frame rate of {2} Hz contradict each other"),
      clause(Code::kTakenAsMetres, "taken as metres"),
      clause(Code::kGiveLengthUnit, "give the unit of the translations"),
      clause(Code::kGiveFileAndUnit, "also give a file that contains it, and the unit of the translations"),

      // The file that is written into.
      bad_request(Code::kIntoWithoutCamera, "into-without-camera", "this file has no camera that the input's could replace",
                  "name the file that holds the cameras, or write a new one"),
      bad_request(Code::kIntoFolder, "into-folder", "the folder is a rig of {0} files, but only one file can be the base",
                  "name the file of the sensor: {1:or}"),
      bad_request(Code::kIntoAnotherFormat, "into-another-format", "the file is {0}, but the given format is {1}",
                  "give no format: the file's own is used"),
      error(Code::kIntoWithoutPose, "pose-missing", "{2} contains only poses, of {3}, and {0} contains none of these{1}",
            "give an input with one of these poses, or write the cameras to another file"),
      clause(Code::kHasOneCamera, " (it has one camera)"),
      bad_request(Code::kModelsDiffer, "models-differ",
                  "a camera with the model {0} stays in the file, and {1} have one model for all cameras",
                  "convert to {0}, or give an input that has all cameras"),
      bad_request(Code::kLayoutWithoutModel, kNoOtherLayout, "this file's layout has no place for {0}; it holds {1}",
                  "convert to {2}, which keeps the file's text, or write another file"),
      error(Code::kSizesContradict, "size-contradicts",
            "{0}: the base is for images of {1} x {2} px, but the input's are of {3} x {4} px",
            "if the base's images are scaled copies of the input's, resize to {1} x {2} px; if the base should be for the "
            "input's images, resize to {3} x {4} px"),
      bad_request(Code::kIntoDoesNotFit, kNoOtherLayout, "what the input contains does not fit into the layout of this file",
                  "write another file"),
      bad_request(Code::kIntoDoesNotFitWords, kNoOtherLayout,
                  "what the input contains does not fit into the layout of this file", "write another file, as {0}"),
      note(Code::kCameraReplaced, "camera-replaced", "{0} of the input takes the place of {1} of the base"),
      note(Code::kPoseFollows, "pose-follows",
           "the base and the input have different poses of {0} relative to {1}; the file gets the one that follows from the "
           "input"),
      note(Code::kCameraKept, "camera-kept", "{0} of the base is not in the input and stays as it is"),
      note(Code::kBaselineKept, "baseline-kept",
           "the input contains no baseline: the base's {0:.2f} cm stay, and bf (baseline times fx) follows"),
      note(Code::kPoseKept, "pose-kept",
           "the input does not contain the pose {0}: the base's stays, unchecked against the new camera"),
      note(Code::kPosesKept, "pose-kept",
           "the input does not contain the poses {0}: the base's stay, unchecked against the new camera"),
      warning(Code::kStaleOfImages, "stale-derived", "{0}: it is for the calibrated images, and stays unchanged",
              "compute it for the new images"),
      warning(Code::kStaleOfLenses, "stale-derived", "{0}: it is for the base's old cameras, and stays unchanged",
              "compute it for the new cameras (cv::stereoRectify)"),
      loss(Code::kStaleOfImagesLost, "stale-derived", "{2}", "it is for the calibrated images, and stays unchanged",
           "compute it for the new images"),
      loss(Code::kStaleOfLensesLost, "stale-derived", "{2}", "it is for the base's old cameras, and stays unchanged",
           "compute it for the new cameras (cv::stereoRectify)"),

      // The cameras.
      warning(Code::kSecondIsLeft, "stereo-order", "{0} sits {1:.2f} cm to the left of {2}; {3}"),
      warning(Code::kEachIsLeft, "stereo-order",
              "{0} sits {1:.2f} cm to the left of {2}, and {2} to the left of {0}: they do not look in one direction with the "
              "same side up; {3}",
              "check their pose; if it is right, they are not a left and a right camera"),
      warning(Code::kPoorFit, "poor-fit", "{0}: {1} does not describe this lens: rms {2:px} px, worst pixel {3:px} px",
              "compare all models; if the corners are black, give the angle at which the lens ends"),
      error(Code::kMisreadBeyondLimit, kLimit, "{0} misreads a camera by up to {1:px} px, more than the limit of {2:px} px"),
      error(Code::kMissingBeyondLimit, kLimit,
            "{0}: as {2}, {1:%} of the image has no pixel or a wrong one, and there is a limit for errors",
            "give {3:.3} deg as the end of the lens, if you need nothing beyond that angle"),
      clause(Code::kInPlaceOfCircle, " in place of the image circle"),
      error(Code::kErrorBeyondLimit, kLimit, "{0}: the worst pixel is off by {1:px} px, more than the limit of {2} px"),
      error(Code::kBoundBeyondLimit, kLimit,
            "{0}: the worst pixel found is off by {1:px} px, but fca-io proves only that the error is below {2:px} px, more "
            "than the limit of {3} px"),
      error(Code::kNoBoundBelowLimit, kLimit,
            "{0}: the worst pixel found is off by {1:px} px, but fca-io cannot prove a bound, and the limit is {2} px"),
      error(Code::kErrorBeyondSigmas, kLimit,
            "{0}: the error reaches {1:.3} standard deviations of the calibration's own pixels, more than the limit of {2}"),
      bad_request(Code::kSigmaUnknown, "sigma-unknown", "{0}: the limit is in standard deviations, and {1}",
                  "set the limit in pixels, or give the covariance of the camera's parameters"),
      clause(Code::kSigmaOnlyLimit,
             "{0} contains the parameters' standard deviations without their correlations, from which only an upper limit in "
             "pixels follows"),
      clause(Code::kSigmaOfRays, "the error of a fit to measured rays contains their noise"),
      clause(Code::kSigmaOfNothing, "no input contains the uncertainty of the calibration"),
      bad_request(Code::kCommonLensNeedsPair, "layout-unfit", "{0} is for a stereo pair of fisheyes (KannalaBrandt8): {1}"),
      note(Code::kCommonLensFitted, "common-lens",
           "{0} and {1} get one k1 to k4, fitted to both, and keep their own fx fy cx cy: the program's pixels are then off by "
           "{2:px} and {3:px} px rms, instead of {4:px} and {5:px} px"),
      note(Code::kPairFitted, "pair-fitted",
           "{0} and {1} are fitted together: after rectification the rows of a point's images differ by {2:px} px rms and "
           "{3:px} px at most, instead of {4:px} and {5:px} px"),
      note(Code::kPairFitDoesNotHelp, "pair-fit-does-not-help",
           "{0} and {1}: no common fit brings the images of a point nearer to one row than the written cameras"),
      bad_request(
          Code::kPairFitNeedsPair, "pair-fit-needs-pair",
          "only a stereo pair can be fitted together: two cameras with a common view, image sizes and a pose between them"),
      bad_request(Code::kPairFitWithOthers, "pair-fit-with-others",
                  "the fit of a pair minimises the rms of all pixels with all parameters free, and already includes turns"),
      error(Code::kLossesNotAllowed, "strict-loss", "the target cannot carry {0:and}, and nothing may be lost"),
      clause(Code::kBetterModelsExist, "{0}"),
      clause(Code::kNoBetterModel, "{0} reads no better model{1}"),
      clause(Code::kBetterModels, "{0} reads {1:and}{2}"),
      clause(Code::kBetterElsewhere, "; for a program that reads it: {0}"),
      clause(Code::kModelExact, "{0} (exact)"),
      clause(Code::kModelRms, "{0} (rms {1:px} px)"),
      clause(Code::kModelRmsUpTo, "{0} (up to {2:.3} deg, rms {1:px} px)"),

      // The files.
      bad_request(Code::kSeveralFiles, "one-output", "{0}: the output has {1} files",
                  "name a folder, or one file: the others go next to it"),
      bad_request(Code::kOneCameraPerFile, "one-camera-per-file", "{0} camera per file, but there are {1}",
                  "name a folder, or a pattern for the files' names, or choose one camera"),
      bad_request(Code::kPartHasNoRoom, "one-output", "{0}: {1} is a separate file, but the output is one file",
                  "name a folder for both"),
      clause(Code::kOfHeadlineOne, "{0}: one"),
      clause(Code::kHoldsOne, "{0} holds one"),
      clause(Code::kArgumentsHeadline, "arguments for {0}'s command line"),
      clause(Code::kHeadlineOfReader, "{0}, as {1} reads it"),
      loss(Code::kImuFileDropped, "second-file-dropped", "{0} with all that it holds",
           "the output is one file, which has no place for it", "write into a folder, where it is a file of its own"),
      note(Code::kMisnamed, "extension",
           "{0} contains {1}, although its name suggests otherwise: programs look at the content"),
      bad_request(Code::kOtherFormInFolder, "other-form-in-folder",
                  "{0} is in that folder: programs open either the text files or the binary files of a model, and would ignore "
                  "the other ones",
                  "write into another folder, or change that model itself"),
      note(Code::kLayoutNotKept, "layout-not-kept",
           "written as a fresh file, without the base's comments, because its layout cannot be kept: {0}"),
      note(Code::kProvenanceHasNoRoom, "provenance-not-written",
           "the comment at the beginning of the file has no room for where the file comes from"),
      note(Code::kProvenanceInBinary, "provenance-not-written",
           "a binary file has no comments that could hold where it comes from"),
      note(Code::kProvenanceInJson, "provenance-not-written", "JSON has no comments that could hold where the file comes from"),

      // What programs say.
      note(Code::kFixed, "mended", "{0}{1}: done"),
      clause(Code::kFixedHow, "; {0}"),
      about_reader(warning(Code::kInputRefused, "program-refuses", "fca-io reads {0}, but its own program would refuse it, {1}",
                           "check the file: the check names the place and the fix")),
      about_reader(warning(Code::kInputNotUnderstood, "program-refuses",
                           "nothing was changed, and {0} does not understand the input itself: {1}",
                           "rewrite it as {0} reads it")),
      about_reader(warning(Code::kEditNotProven, "program-refuses",
                           "{2} is edited, but not proven: {0} refuses the file before and after the edit: {1}",
                           "rewrite it as {0} reads it")),
      about_reader(error(Code::kProofFailed, "proof-failed", "{0} would not understand what was to be written: {1}")),
      about_reader(error(Code::kProofOfBaseFailed, "proof-failed", "{0} would not understand what was to be written: {1}",
                         "check the base file itself; if it is right, choose a simpler mode")),
      about_reader(note(Code::kNotProven, "not-proven",
                        "{0}no program that fca-io knows reads these keys, so nothing is proven",
                        "rewrite it with the keys that {1} reads")),
      clause(Code::kOfPath, "{0}: "),
      clause(Code::kWouldRefuse, "it would refuse the file: {0:and}"),
      clause(Code::kPosesDiffer, "an element of its poses differs by {0:.3}"),
      clause(Code::kNumbersDiffer, "{0:and}"),
      clause(Code::kHasNoPixel, "it has no pixel where the model has one"),
      clause(Code::kPixelsDiffer, "its pixels differ by up to {0:px} px"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
