// SPDX-License-Identifier: BSD-3-Clause
// OpenCV's files, as read and written. {0} of what a reader says is the key ("camera_0 camera_matrix").
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kLength = "wrong-length";
constexpr std::string_view kContradicts = "model-contradicts";
constexpr std::string_view kForBaselines = "keep it for programs that ask for it by itself";

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
            "no 3 x 3 camera matrix under a usual key (camera_matrix, M1, K1, camera_0 ...) is in the file",
            "OpenCV's calibration samples write camera_matrix and distortion_coefficients"),
      error(Code::kOpencvCameraTwice, "stated-twice", "a camera {0} is here and in the file before"),
      reader_warning(Code::kOpencvCameraCount, "program-refuses",
                     "{0} is {1}, but there are {2} cameras; MC-Calib's reader stops"),

      // Read: matrices.
      error(Code::kOpencvMatrixOfIntegers, "matrix-type",
            "{0} holds dt '{1}', whole numbers; OpenCV's functions want floating-point numbers", "write dt: d"),
      error(Code::kOpencvMatrixType, "matrix-type", "{0} holds dt '{1}'; d (double) or f (float) is wanted"),
      error(Code::kOpencvNotCameraMatrixSize, kLength, "{0} is {1} x {2}; a camera matrix is 3 x 3"),
      error(Code::kOpencvMatrixTransposed, "matrix-transposed",
            "{0} is transposed: its principal point stands in the last row, as MATLAB writes it",
            "OpenCV wants fx 0 cx, 0 fy cy, 0 0 1 row by row"),
      error(Code::kOpencvMatrixNotTransposed, "matrix-transposed",
            "{0} is next to MATLAB's keys and is not transposed as MATLAB's is",
            "MATLAB writes fx 0 0, s fy 0, cx cy 1 row by row"),
      error(Code::kOpencvMatrixNonZero, "not-a-camera-matrix", "{0} has {1} where a camera matrix has 0"),
      warning(Code::kOpencvMatrixCorner, "matrix-corner",
              "{0}(2, 2) is {1}, not 1; OpenCV's projections do not read it, but K * p and inv(K) come out wrong", "write 1.0"),
      warning(Code::kOpencvMatlabOrigin, "matlab-origin",
              "{0} is MATLAB's, which counts pixels from 1; its principal point is read as it stands",
              "if nothing has subtracted 1 from it yet (stereoParametersToOpenCV does), subtract 1 from both numbers"),
      reader_warning(Code::kOpencvSkewKept, "skew",
                     "{0} has a skew of {1} px at (0, 1), which is a part of the camera; cv::projectPoints and cv::fisheye "
                     "ignore it",
                     "write 0 there if the program that uses the file ignores it, too"),
      error(Code::kOpencvSizeNotTwoNumbers, kLength, "{0} must be two numbers"),
      error(Code::kOpencvNotVector, kLength, "{0} is {1} x {2}; a vector is wanted"),
      error(Code::kOpencvRadialNumbers, kLength, "{0} has {1} numbers; 2 or 3 are wanted"),
      error(Code::kOpencvXiNumbers, kLength, "{0} has {1} numbers; one is wanted"),

      // Read: poses.
      error(Code::kOpencvPoseNotFourByFour, kLength, "{0} is {1} x {2}; 4 x 4 is wanted"),
      error(Code::kOpencvNotRotationMatrix, kLength, "{0} is {1} x {2}; a 3 x 3 rotation is wanted"),
      error(Code::kOpencvNotRotationVector, kLength, "{0} is {1} x {2}; a rotation vector of 3 numbers is wanted"),
      error(Code::kOpencvAngleTooLarge, "not-a-rotation", "{0} turns by {1:.3} rad",
            "a rotation vector is an axis times the angle in radians"),
      warning(Code::kOpencvUnitsNotStated, "units-not-stated",
              "{0} is {1:.4} long, in the units of the calibration board, which no file contains; read as metres, probably "
              "millimetres",
              "divide it by 1000 if they are millimetres"),
      warning(Code::kOpencvPoseMissing, "pose-missing", "the pose of the second camera needs R and T, and {0} is missing"),

      // Read: which lens the coefficients are of.
      clause(Code::kOpencvNoCoefficients, "{0} has no distortion coefficients next to it"),
      clause(Code::kOpencvSomeCoefficients, "{0} has {1} numbers"),
      clause(Code::kOpencvSaysOmnidir, "{0} says cv::omnidir"),
      clause(Code::kOpencvIsMatlabs, "{0} is MATLAB's"),
      error(Code::kOpencvFisheyeWithout, "distortion-missing", "{0} and the file specifies fisheye; cv::fisheye wants 4"),
      warning(Code::kOpencvReadWithout, "distortion-missing", "{0}: read as a lens without distortion"),
      error(Code::kOpencvFisheyeWantsFour, kLength, "{0} has {1} numbers and the file specifies fisheye; cv::fisheye wants 4"),
      error(Code::kOpencvOmnidirWantsFour, kLength, "{0}, which wants 4 distortion coefficients, not {1}"),
      error(Code::kOpencvCoefficientCount, kLength, "{0} has {1} numbers; OpenCV knows vectors of 0, 4, 5, 8, 12 and 14"),
      error(Code::kOpencvForeignModel, "unknown-model",
            "{0} is '{1}': a model that none of cv::projectPoints, cv::fisheye and cv::omnidir has",
            "if the numbers are one of theirs all the same, say which: pinhole or fisheye"),
      warning(Code::kOpencvForeignModelAsTold, "unknown-model",
              "{0} is '{1}': a model that none of cv::projectPoints, cv::fisheye and cv::omnidir has; read as {2}, as told"),
      warning(Code::kOpencvToldInVain, kContradicts,
              "{0}: that the model is fisheye, which was told and is about four coefficients, has no effect on this camera"),
      warning(Code::kOpencvToldOtherwise, kContradicts, "{0} is {1} by the file and read as {2}, as told"),
      error(Code::kOpencvAmbiguousModel, "ambiguous-model",
            "{0} has four numbers and nothing in the file shows of what: pinhole k1={1} k2={2} p1={3} p2={4} "
            "(cv::projectPoints), or fisheye k1={1} k2={2} k3={3} k4={4} (cv::fisheye)",
            "say which: pinhole or fisheye"),

      // Edited: keys that no longer belong to what the file says.
      warning(Code::kOpencvStale, "stale-derived", "{0}: {1}", "{2}"),
      loss(Code::kOpencvStaleKept, "stale-derived", "{2}", "{3}", "{4}"),
      clause(Code::kOpencvOfRectification,
             "computed from the old cameras and their pose (cv::stereoRectify, cv::stereoCalibrate) and kept unchanged"),
      clause(Code::kOpencvRectifyAgain,
             "run cv::stereoRectify on the new numbers (E = [T]x R, F = inv(M2)' E inv(M1)), or remove the keys"),
      clause(Code::kOpencvOfCalibration, "left by the calibration that gave the old numbers and kept unchanged"),
      clause(Code::kOpencvCalibrateAgain, "remove the keys, or calibrate again"),
      clause(Code::kOpencvOfSecondStatement, "a second statement of the old cameras and kept unchanged"),
      clause(Code::kOpencvRemoveKeys, "remove the keys"),

      // Written: losses and their reasons.
      clause(Code::kOpencvHasNoKey, "OpenCV's files have no key for it"),
      clause(Code::kOpencvHolds, "only cameras, image sizes and poses are written into an OpenCV file"),
      clause(Code::kOpencvKeepsItsOwn, "{0}; the one written into keeps its own"),
      loss(Code::kOpencvImuDropped, "imu-dropped", "{0} noise and rate", "OpenCV's files have no key for them",
           "keep its file; a complete IMU can be written to one of Kalibr's"),
      loss(Code::kOpencvBaselineDropped, "baseline-dropped", "{1} {2} m",
           "OpenCV's files contain poses of cameras, and the second camera is not in the input", kForBaselines),
      loss(Code::kOpencvCameraDropped, "camera-dropped", "{0} ({2})",
           "the file written into holds R and T of a pair and no camera", "write the cameras into an OpenCV file of their own"),
      loss(Code::kOpencvPosesDropped, "pose-dropped", "{2}", "the file written into holds the pose of one pair"),
      loss(Code::kOpencvSizeDropped, "image-size-dropped", "{0} {2}x{3}",
           "the keys written into hold one image size for both cameras, and theirs differ",
           "the layout cameras has a size for each"),

      // Written: why a file is composed anew.
      clause(Code::kOpencvOtherCameras, "its cameras are other ones"),
      clause(Code::kOpencvKeysCannotHoldModel, "its keys cannot hold the model {0}"),
      clause(Code::kOpencvOneKind, "its cameras must be of one kind"),
      clause(Code::kOpencvOneSize, "it has one image size for both cameras"),
      clause(Code::kOpencvRotationVector, "it contains the rotation as a vector"),
      clause(Code::kOpencvOtherLayout, "another layout was asked for"),
      clause(Code::kOpencvOtherSyntax, "another syntax was asked for"),

      // Written: why a layout cannot hold a rig.
      clause(Code::kOpencvMeiAlone, "it is for the model mei alone"),
      clause(Code::kOpencvNoKeyForXi, "it has no key for the xi of mei"),
      clause(Code::kOpencvTwoCameras, "it holds two cameras, not {0}"),
      clause(Code::kOpencvSizesDiffer, "it has one image size for both cameras, and theirs differ"),
      clause(Code::kOpencvKindsDiffer, "its cameras must be of one kind, and theirs differ"),
      bad_request(Code::kOpencvLayoutNotServed, "layout-not-served", "the layout {0} cannot hold this rig: {1}",
                  "leave the layout open, or choose {2}"),
      bad_request(Code::kOpencvUnknownLayout, "unknown-layout", "OpenCV files have no layout '{0}'"),

      // Written: the rest.
      error(Code::kOpencvNoCamera, "no-camera", "an OpenCV calibration needs a camera and the input has none"),
      error(Code::kOpencvPoseNotRead, "no-calibration", "R and T of the file written into cannot be read"),
      note(Code::kOpencvWrittenAmbiguous, "ambiguous-model",
           "what is written does not say what its four coefficients are; they are meant as {0} ({1})",
           "whoever reads it must know {0}"),
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
