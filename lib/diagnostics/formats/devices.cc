// SPDX-License-Identifier: BSD-3-Clause
// Memories of devices (DepthAI, RealSense, ZED) and what OpenImuCameraCalibrator writes: files that are only read.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> device_codes() {
  static constexpr std::array kRows = {
      // Files with a lens for each size of images: the sizes, "1280x720".
      error(Code::kDeviceSizeNeeded, "size-needed", "the file has a lens for each size of images: {0:and}",
            "give the size of your images"),
      error(Code::kDeviceSizeUnknown, "size-contradicts", "the file has no lens for images of {0}, but for {1:and}",
            "give the size at which the device recorded, and the size to which the images were scaled since"),
      warning(Code::kDeviceCameraOfOtherSize, "size-contradicts",
              "{0} is left out: it has no lens for images of {1}, but for {2:and}",
              "give a size that all cameras have, if the images were recorded in it"),

      error(Code::kDepthaiNoPair, "not-a-list", "{0} is not a pair of a socket and its camera's data"),
      error(Code::kDepthaiSocketTwice, "duplicate-key", "{0} appears twice in cameraData"),
      note(Code::kDepthaiImuDirection, "pose-doubtful",
           "imuExtrinsics is read as the programs read it: it takes points of the IMU to points of {0}. Some boards are "
           "reported to contain the inverse",
           "compare it with the board: the IMU's origin is at {1:.3}, {2:.3}, {3:.3} m in {0} (right, down, forward)"),
      error(Code::kOpeniccSkew, "skew", "{0} is {1}, and fca-io has no {2} lens with skew",
            "the calibrator itself writes 0: calibrate again, or with FISHEYE, which may have one"),
      error(Code::kOpeniccDivisionAspect, "unknown-model",
            "{0} is {1}: this program's division model counts the radius in pixels, and fca-io has no such model with pixels "
            "that are not square",
            "calibrate with FISHEYE or DOUBLE_SPHERE, or hold the aspect ratio at 1"),
      warning(Code::kZedFisheyeByZeros, "lens-in-doubt",
              "{0} is read as a fisheye: it has k1 to k4, and p1, p2, k5 and k6 are 0, with which ZED's tools fill up a "
              "fisheye's coefficients",
              "if it is a fisheye, remove p1 and p2"),
      note(Code::kZedHeightOfSign, "pose-doubtful",
           "TY and TZ ({0} and {1} mm) are read as Stereolabs' calibration tool writes them: where the left camera is, in the "
           "right one. Programs differ about their sign"),
      warning(Code::kNcoreGlass, "lens-in-doubt",
              "{0} looks through a windshield that bends its rays (external_distortion), and fca-io reads the lens without it",
              "measure the pixels of rays with NCore's own code, windshield included, and read them as a table of rays"),
      with_consequence(warning(Code::kNcoreInverseFarOff, "stale-inverse",
                               "{0}: {1} is not the inverse of {3}: it is up to {2:.3} px off within {4:.3} deg, where it ends "
                               "or max_angle_rad does. fca-io uses {3}",
                               "ask whoever wrote the file which one is right: a program that uses {1} sees another lens"),
                       "Programs that use one polynomial and programs that use the other disagree by that many pixels."),
      note(Code::kRealsenseInverseModel, "lens-in-doubt",
           "{0} has the model {1} with coefficients that are not 0. It is read as Brown Conrady from ray to pixel, as "
           "librealsense's ROS driver does. librealsense itself applies p1 and p2 to the distorted point, which differs by "
           "some hundredths of a pixel; older versions took the lens from pixel to ray"),
      warning(Code::kRealsenseBlocksDiffer, "model-contradicts",
              "{0} at {1} appears twice with different numbers; the first is read"),
      warning(Code::kRealsenseCopiedBlock, "pose-doubtful",
              "the block from {0} to {1} is not read: it contradicts the others by {2:.3} m. librealsense prints the block of "
              "Infrared 1 in its place",
              "nothing to do, if the pose of Infrared 2 to Infrared 1 is the device's; otherwise use a newer librealsense"),
      note(Code::kRealsenseDepthIsInfrared, "program-ignores",
           "{0} is left out: it has the lens and the place of {1}, from whose images it is computed"),
      clause(Code::kNcoreInverse, "within {0:.2} px of the inverse of {1}, proven up to {2:.3} degrees: {3}"),
      clause(Code::kRealsenseFound, "the intrinsics of a stream, as librealsense names them"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
