// SPDX-License-Identifier: BSD-3-Clause
// What the ORB-SLAM programs report about a file. {0} is the key where there is one; of sizes rows come first.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> orbslam_program_codes() {
  static constexpr std::array kRows = {
      // Of all of them.
      refusal(Code::kOrbslamNoSensor, "there is no sensor '{0}'"),
      refusal(Code::kOrbslamXml, "the file is XML, whose names cannot have the '.' of these keys"),
      refusal(Code::kOrbslamNoHeader,
              "the first bytes are not '%YAML:1.0'; OpenCV's reader does not take the file (no comment, blank line or BOM "
              "before it)"),
      named_refusal(Code::kOrbslamKeyMissing, "{0} is missing; {1} exits", kAddTheKey),
      named_refusal(Code::kOrbslamNotReal, "{0} is {1}; {2} wants a number with a '.' and exits{3}"),
      named_refusal(Code::kOrbslamNotInt, "{0} is {1}; {2} wants an int and exits{3}"),
      remedy(Code::kOrbslamWriteInt, "real-for-int", ": write {0}"),
      named_refusal(Code::kOrbslamNotText, "{0} is {1}; {2} wants a string in quotes and exits"),
      named_misreading(Code::kOrbslamTakesLargest, "{0} is {1}, not a number; {2} takes OpenCV's largest number for it"),
      named_refusal(Code::kOrbslamNoMatrix, "{0} is {1}; {2} wants an !!opencv-matrix (rows, cols, dt, data)"),
      named_refusal(Code::kOrbslamUnreadableMatrix, "{0} is not a matrix that OpenCV can read ({1}); {2} stops"),
      named_misreading(Code::kOrbslamPoseOfDoubles,
                       "{0} is dt: d; {1} reads its bytes as floats, so the pose is garbage: write dt: f"),
      named_misreading(Code::kOrbslamPoseNotOfFloats,
                       "{0} is not dt: f; {1} reads its bytes as floats, so the pose is garbage: write dt: f"),
      named_misreading(Code::kOrbslamSkipsUndistortion,
                       "{0} is 0.0, so {1} skips the whole undistortion and k2 p1 p2 k3 are ignored"),

      // ORB-SLAM2 and slam_no_opt.
      named_misreading(Code::kOrbslamTakesZero, "{0} is missing; {1} takes 0", kAddTheKey),
      named_refusal(Code::kOrbslamNoLevels, "{0} is missing or 0; {1} builds an empty image pyramid and crashes", kAddTheKey),
      named_refusal(Code::kOrbslamNotInertial, "{0} has no inertial mode"),
      named_refusal(Code::kOrbslamNoBaseline, "{0} is missing; {1} takes 0, and without a baseline there is no depth",
                    kAddTheKey),
      named_refusal(Code::kOrbslamNoFocalLength, "{0} is missing or 0; ORB-SLAM2 takes 0 and divides by it", kAddTheKey),
      named_misreading(Code::kOrbslamTypeNotRead,
                       "{0} is {1}; ORB-SLAM2 does not read it and takes every file as PinHole k1 k2 p1 p2 k3"),
      named_misreading(Code::kOrbslam2SkipsUndistortion,
                       "{0} is 0, so ORB-SLAM2 skips the whole undistortion and k2 p1 p2 k3 are ignored"),
      refusal(Code::kOrbslamNoOptTypeMissing, "{0} is missing; slam_no_opt knows EUCM and KB and is left without a camera",
              kAddTheKey),
      refusal(Code::kOrbslamNoOptType, "{0} is {1}; slam_no_opt knows EUCM and KB and is left without a camera"),
      misreading(Code::kOrbslamNoOptK3Ignored,
                 "{0}, k4 are ignored: slam_no_opt reads k3 and k4 of KB from Camera.p1 and Camera.p2"),
      misreading(Code::kOrbslamEucmRefusesAll,
                 "{0}: alpha is {1:.6f}; slam_no_opt's limit 1/(beta (2 alpha - 1)) is negative for alpha < 0.5 and refuses "
                 "every point"),
      refusal(Code::kOrbslamSmallMatrix, "{0} is {1} x {2}; {3} reads {4} x {5} without a check"),

      // The old parser of ORB-SLAM3.
      named_refusal(Code::kOrbslamOldTypeMissing, "{0} is missing; {1} (old style) knows {2:,} and is left without a camera{3}",
                    kAddTheKey),
      named_refusal(Code::kOrbslamOldType, "{0} is {1}; {2} (old style) knows {3:,} and is left without a camera{4}"),
      clause(Code::kOrbslamKeysOfV1, " (the Camera1.* keys belong to a file with File.version: \"1.0\")"),
      named_refusal(Code::kOrbslamViewerStops, "{0} is missing; the viewer of {1} stops", kAddTheKey),
      named_misreading(Code::kOrbslamK3IsInt, "{0} is an int; {1} (old style) ignores it: write it with a '.'"),
      misreading(Code::kOrbslamRectifiedElsewhere,
                 "LEFT.*/RIGHT.*: only the example program stereo_euroc reads them, to rectify; Camera.* must be the "
                 "rectified camera"),
      named_misreading(Code::kOrbslamLappingNotInt, "{0} is not an int; {1} only prints a warning"),
      named_refusal(Code::kOrbslamPairSize, "{0} is {1} x {2}; {3} (old style) wants exactly 3 x 4"),
      named_refusal(Code::kOrbslamImuSize, "{0} is {1} x {2}; {3} (old style) wants exactly 4 x 4 floats"),
      named_refusal(Code::kOrbslamSophusAborts,
                    "{0}: its left 3 x 3 is not a rotation to 1e-5 (R R^T - I is {1:.6f}); Sophus inside {2} (old style) "
                    "aborts: write more digits"),
      named_misreading(Code::kOrbslamVersionNotText,
                       "{0} is {1}; ORB-SLAM3 V1.0 uses its old parser unless it is the string \"1.0\""),

      // ORB-SLAM3 V1.0.
      named_refusal(Code::kOrbslamV1Type, "{0} is {1}; ORB-SLAM3 V1.0 knows PinHole, Rectified, KannalaBrandt8 and exits{2}"),
      clause(Code::kOrbslamCommentInText,
             " (OpenCV reads a comment after an unquoted string as part of the string: use quotes)"),
      misreading(Code::kOrbslamIgnoredWithoutK1, "{0} is ignored: without {1} there is no distortion"),
      misreading(Code::kOrbslamRectifiedIgnores, "{0} is ignored: Rectified images have no distortion"),
      misreading(Code::kOrbslamRectifiedAlike,
                 "Camera2.* is ignored: in the type Rectified, both cameras have the numbers of Camera1"),
      named_refusal(Code::kOrbslamSecondNeverRead,
                    "KannalaBrandt8 with rgbd-inertial: ORB-SLAM3 V1.0 uses a second camera that was never read and crashes"),
      named_refusal(
          Code::kOrbslamReadsNull,
          "{0} without Camera1.k1: ORB-SLAM3 V1.0 takes camera 2's distortion from camera 1's empty array and reads a "
          "null pointer"),
      named_misreading(Code::kOrbslamReadsAfterFour,
                       "{0} without Camera1.k3: ORB-SLAM3 V1.0 reads beyond camera 1's four coefficients"),
      named_misreading(Code::kOrbslamSecondPinholeIgnored, "{0} k2 p1 p2 are ignored: ORB-SLAM3 V1.0 uses camera 1's"),
      named_misreading(Code::kOrbslamSecondFisheyeIgnored,
                       "{0}..k4 differ from Camera1.k1..k4 and are ignored: ORB-SLAM3 V1.0 reads Camera1.k1..k4 for both "
                       "KannalaBrandt8 cameras"),
      named_refusal(Code::kOrbslamPoseSize, "{0} is {1} x {2}; ORB-SLAM3 V1.0 wants 4 x 4 floats and stops"),
      named_misreading(Code::kOrbslamSomeQuaternion,
                       "{0} has no rotation in its left 3 x 3; ORB-SLAM3 V1.0 turns it into an arbitrary quaternion"),
      named_misreading(
          Code::kOrbslamNewSizeRectified,
          "{0}/newHeight with stereo PinHole: ORB-SLAM3 V1.0 passes the new size to the rectification as the size of "
          "the calibration, without scaling fx fy cx cy"),
      named_misreading(
          Code::kOrbslamHalfPixelOff,
          "{0}/newHeight: ORB-SLAM3 V1.0 scales cx and cy without the half pixel that cv::resize counts from, so its "
          "centre is {1:.2} px off"),
      named_misreading(Code::kOrbslamDepthNotUndistorted,
                       "{0} k2 p1 p2 are ignored: ORB-SLAM3 V1.0 undistorts only for the mono sensors, not for RGB-D"),
      named_misreading(
          Code::kOrbslamDepthByPinhole,
          "KannalaBrandt8 is ignored for depth: ORB-SLAM3 V1.0 turns RGB-D pixels into points with the plain pinhole "
          "formula, without undistorting them"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
