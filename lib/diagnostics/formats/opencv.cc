// SPDX-License-Identifier: BSD-3-Clause
// OpenCV's files, as read and written. {0} of what a reader says is the key ("camera_0 camera_matrix").
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kLength = "wrong-length";
constexpr std::string_view kContradicts = "model-contradicts";
constexpr std::string_view kForBaselines = "keep it for programs that ask for the baseline separately";

}  // namespace

std::span<const CodeInfo> opencv_codes() {
  static constexpr std::array kRows = {
      // How a file was recognised.
      clause(Code::kOpencvFoundCamera, "opencv-matrix under {0}{1}"),
      clause(Code::kOpencvFoundMap, "opencv-matrix under {0} with {1}{2}"),
      clause(Code::kOpencvFoundFurtherKey, " and {0}"),
      clause(Code::kOpencvFoundPose, "opencv-matrix under R and T of a stereo pair"),

      // Read: the file.
      error(Code::kOpencvNoCalibration, "no-calibration",
            "the file has no 3 x 3 camera matrix under a usual key (camera_matrix, M1, K1, camera_0 ...)",
            "OpenCV's calibration samples write camera_matrix and distortion_coefficients"),
      error(Code::kOpencvCameraTwice, "stated-twice", "the camera {0} is here and earlier in the file"),
      reader_warning(Code::kOpencvCameraCount, "program-refuses",
                     "{0} is {1}, but there are {2} cameras; MC-Calib's reader stops"),

      // Read: matrices.
      error(Code::kOpencvMatrixOfIntegers, "matrix-type",
            "{0} has dt '{1}', whole numbers; OpenCV's functions want floating-point numbers", "write dt: d"),
      error(Code::kOpencvMatrixType, "matrix-type", "{0} has dt '{1}'; it must be d (double) or f (float)"),
      error(Code::kOpencvNotCameraMatrixSize, kLength, "{0} is {1} x {2}; a camera matrix is 3 x 3"),
      error(Code::kOpencvMatrixTransposed, "matrix-transposed",
            "{0} is transposed: its principal point is in the last row, as MATLAB writes it",
            "write fx 0 cx, 0 fy cy, 0 0 1 row by row"),
      error(Code::kOpencvMatrixNotTransposed, "matrix-transposed",
            "{0} is next to MATLAB's keys and is not transposed as MATLAB's is",
            "MATLAB writes fx 0 0, s fy 0, cx cy 1 row by row"),
      error(Code::kOpencvMatrixNonZero, "not-a-camera-matrix", "{0} has {1} where a camera matrix has 0"),
      warning(Code::kOpencvMatrixCorner, "matrix-corner",
              "{0}(2, 2) is {1}, not 1; OpenCV's projections do not read it, but K * p and inv(K) come out wrong", "write 1.0"),
      warning(Code::kOpencvMatlabOrigin, "matlab-origin",
              "{0} is MATLAB's, which counts pixels from 1; fca-io reads its principal point unchanged",
              "if nothing has subtracted 1 from it yet (stereoParametersToOpenCV does), subtract 1 from both numbers"),
      reader_warning(Code::kOpencvSkewKept, "skew",
                     "{0} has a skew of {1} px at (0, 1), which is a part of the camera; cv::projectPoints and cv::fisheye "
                     "ignore it",
                     "write 0 there if the program that uses the file also ignores it"),
      error(Code::kOpencvSizeNotTwoNumbers, kLength, "{0} must be two numbers"),
      error(Code::kOpencvNotVector, kLength, "{0} is {1} x {2}; it must be a vector"),
      error(Code::kOpencvRadialNumbers, kLength, "{0} has {1} numbers; it must have 2 or 3"),
      error(Code::kOpencvXiNumbers, kLength, "{0} has {1} numbers; it must have one"),

      // Read: poses.
      error(Code::kOpencvPoseNotFourByFour, kLength, "{0} is {1} x {2}; it must be 4 x 4"),
      error(Code::kOpencvNotRotationMatrix, kLength, "{0} is {1} x {2}; it must be a 3 x 3 rotation"),
      error(Code::kOpencvNotRotationVector, kLength, "{0} is {1} x {2}; it must be a rotation vector of 3 numbers"),
      error(Code::kOpencvAngleTooLarge, "not-a-rotation", "{0} turns by {1:.3} rad",
            "write the rotation axis times the angle in radians"),
      warning(Code::kOpencvUnitsNotGiven, "units-not-stated",
              "{0} is {1:.4} long, in the unit of the calibration board, which no file contains; it is read as metres, but is "
              "probably in millimetres",
              "divide it by 1000 if they are millimetres"),
      warning(Code::kOpencvPoseMissing, "pose-missing", "the pose of the second camera needs R and T, but {0} is missing"),

      // Read: which lens the coefficients are of.
      clause(Code::kOpencvNoCoefficients, "{0} has no distortion coefficients next to it"),
      clause(Code::kOpencvSomeCoefficients, "{0} has {1} numbers"),
      clause(Code::kOpencvSaysOmnidir, "{0} says cv::omnidir"),
      clause(Code::kOpencvIsMatlabs, "{0} is MATLAB's"),
      error(Code::kOpencvFisheyeWithout, "distortion-missing", "{0}, but the file specifies fisheye; cv::fisheye needs 4"),
      warning(Code::kOpencvReadWithout, "distortion-missing", "{0}: read as a lens without distortion"),
      error(Code::kOpencvFisheyeWantsFour, kLength, "{0} has {1} numbers, but the file specifies fisheye; cv::fisheye needs 4"),
      error(Code::kOpencvOmnidirWantsFour, kLength, "{0}, which needs 4 distortion coefficients, not {1}"),
      error(Code::kOpencvCoefficientCount, kLength, "{0} has {1} numbers; OpenCV knows vectors of 0, 4, 5, 8, 12 and 14"),
      error(Code::kOpencvForeignModel, "unknown-model",
            "{0} is '{1}', a model of neither cv::projectPoints nor cv::fisheye nor cv::omnidir",
            "if the numbers are nevertheless one of theirs, name the model: pinhole or fisheye"),
      warning(
          Code::kOpencvForeignModelAsGiven, "unknown-model",
          "{0} is '{1}', a model of neither cv::projectPoints nor cv::fisheye nor cv::omnidir; it is read as the given {2}"),
      warning(Code::kOpencvGivenInVain, kContradicts,
              "{0}: the given model fisheye, which is for four coefficients, has no effect on this camera"),
      warning(Code::kOpencvGivenOtherwise, kContradicts, "{0} is {1} in the file, but is read as the given {2}"),
      error(Code::kOpencvAmbiguousModel, "ambiguous-model",
            "{0} has four numbers, and the file does not tell which model: pinhole k1={1} k2={2} p1={3} p2={4} "
            "(cv::projectPoints), or fisheye k1={1} k2={2} k3={3} k4={4} (cv::fisheye)",
            "name the model: pinhole or fisheye"),

      // Edited: keys that no longer belong to what the file says.
      warning(Code::kOpencvStale, "stale-derived", "{0}: {1}", "{2}"),
      loss(Code::kOpencvStaleKept, "stale-derived", "{2}", "{3}", "{4}"),
      clause(Code::kOpencvOfRectification,
             "computed from the old cameras and their pose (cv::stereoRectify, cv::stereoCalibrate), and unchanged"),
      clause(Code::kOpencvRectifyAgain,
             "run cv::stereoRectify on the new numbers (E = [T]x R, F = inv(M2)' E inv(M1)), or remove the keys"),
      clause(Code::kOpencvOfCalibration, "left by the calibration of the old numbers, and unchanged"),
      clause(Code::kOpencvCalibrateAgain, "remove the keys, or calibrate again"),
      clause(Code::kOpencvOfSecondStatement, "a second copy of the old cameras, and unchanged"),
      clause(Code::kOpencvRemoveKeys, "remove the keys"),

      // Written: losses and their reasons.
      clause(Code::kOpencvHasNoKey, "OpenCV's files have no key for it"),
      clause(Code::kOpencvHolds, "an OpenCV file gets only cameras, image sizes and poses"),
      clause(Code::kOpencvKeepsItsOwn, "{0}; the base file keeps its own"),
      loss(Code::kOpencvImuDropped, "imu-dropped", "{0} noise and rate", "OpenCV's files have no key for them",
           "keep its file; a complete IMU can be written to one of Kalibr's"),
      loss(Code::kOpencvBaselineDropped, "baseline-dropped", "{1} {2} m",
           "OpenCV's files contain poses of cameras, and the second camera is not in the input", kForBaselines),
      loss(Code::kOpencvCameraDropped, "camera-dropped", "{0} ({2})", "the base file holds R and T of a pair and no camera",
           "write the cameras into an OpenCV file of their own"),
      loss(Code::kOpencvPosesDropped, "pose-dropped", "{2}", "the base file holds the pose of one pair"),
      loss(Code::kOpencvSizeDropped, "image-size-dropped", "{0} {2}x{3}",
           "the keys of the base file hold one image size for both cameras, and theirs differ",
           "the layout cameras has a size for each"),

      // Written: why a file is rewritten.
      clause(Code::kOpencvOtherCameras, "its cameras are other ones"),
      clause(Code::kOpencvKeysCannotHoldModel, "its keys cannot hold the model {0}"),
      clause(Code::kOpencvOneKind, "its cameras must be of one kind"),
      clause(Code::kOpencvOneSize, "it has one image size for both cameras"),
      clause(Code::kOpencvRotationVector, "it contains the rotation as a vector"),
      clause(Code::kOpencvOtherLayout, "another layout was asked for"),
      clause(Code::kOpencvOtherSyntax, "another syntax was asked for"),

      // Written: why a layout cannot hold a rig.
      clause(Code::kOpencvMeiAlone, "it is only for the model mei"),
      clause(Code::kOpencvNoKeyForXi, "it has no key for the xi of mei"),
      clause(Code::kOpencvTwoCameras, "it holds two cameras, not {0}"),
      clause(Code::kOpencvSizesDiffer, "it has one image size for both cameras, and theirs differ"),
      clause(Code::kOpencvKindsDiffer, "its cameras must be of one kind, and theirs differ"),
      bad_request(Code::kOpencvLayoutNotServed, "layout-not-served", "the layout {0} cannot hold this rig: {1}",
                  "give no layout, or {2}"),
      bad_request(Code::kOpencvUnknownLayout, "unknown-layout", "OpenCV files have no layout '{0}'"),

      // Written: the rest.
      error(Code::kOpencvNoCamera, "no-camera", "an OpenCV calibration needs a camera, but the input has none"),
      error(Code::kOpencvPoseNotRead, "no-calibration", "R and T of the base file cannot be read"),
      note(Code::kOpencvWrittenAmbiguous, "ambiguous-model",
           "the written file does not tell the model of its four coefficients; it is {0} ({1})",
           "tell whoever reads the file that it is {0}"),
      clause(Code::kOpencvFirstIsLeft, "StereoBM and StereoSGBM take the first camera of a rectified pair for the left one"),
      clause(Code::kOpencvWrotePose, "the pose of a stereo pair"),
      clause(Code::kOpencvWroteCalibration, "the keys of OpenCV's camera_calibration sample"),
      clause(Code::kOpencvWroteStereo, "the keys of OpenCV's stereo_calib sample, intrinsics and extrinsics in one file"),
      clause(Code::kOpencvWroteMaps, "MC-Calib's keys, one camera_<i> per camera"),
      clause(Code::kOpencvWroteLeftRight, "camera_matrix_left and camera_matrix_right"),
      clause(Code::kOpencvWroteOmnidir, "the keys of ccalib's omnidir samples"),
      clause(Code::kOpencvLayouts, "calibration, stereo, omnidir, cameras or left-right (default: what the cameras need)"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
