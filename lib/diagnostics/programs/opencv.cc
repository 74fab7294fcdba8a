// SPDX-License-Identifier: BSD-3-Clause
// What OpenCV's functions read from a file. {0} is what is spoken of, "camera_0.camera_matrix"; of sizes rows come first.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> opencv_program_codes() {
  static constexpr std::array kRows = {
      named_refusal(Code::kCvNoCameraMatrix,
                    "no camera matrix under a key that OpenCV's samples read: camera_matrix, M1, K1, camera_matrix_1, "
                    "camera_matrix_left, camera_0"),
      misreading(Code::kCvOtherMatrixFirst, "{0} is not read: {1} comes first"),
      refusal(Code::kCvNoMatrix, "{0} is not an !!opencv-matrix (rows, cols, dt, data)"),
      named_refusal(Code::kCvUnreadableMatrix, "{0} is not a matrix that OpenCV can read ({1})"),
      named_refusal(Code::kCvCameraMatrixSize, "{0} is {1} x {2}{3}; OpenCV's functions want 3 x 3 floating-point numbers"),
      clause(Code::kCvNotReal, " and not of dt: d or f"),
      misreading(Code::kCvMatrixTransposed,
                 "{0} has numbers below its diagonal, which are not read: is it transposed, as MATLAB's?"),
      named_refusal(Code::kCvDistortionSize,
                    "{0} is {1} x {2}; OpenCV wants a floating-point vector of 4, 5, 8, 12 or 14 numbers"),
      named_misreading(Code::kCvDistortionMissing,
                       "{0} is missing; OpenCV reads an empty matrix and projects without distortion", kAddTheKey),
      misreading(Code::kCvGivenOtherwise, "{0}: the file contains {1}, the caller asks for {2}"),
      misreading(Code::kCvFourNumbers,
                 "{0} has 4 numbers, and the file does not tell which function they are for: cv::projectPoints takes k1 k2 p1 "
                 "p2, cv::fisheye k1 k2 k3 k4; taken as the former"),
      refusal(Code::kCvCoefficientsNotFour, "{0}: {1} distortion coefficients; {2} wants 4"),
      misreading(Code::kCvSkewUnused, "{0} has a skew of {1:all} px, which {2} does not use: up to {3:all} px"),
      refusal(Code::kCvPairIncomplete, "{0} is missing; a program that reads a pair of cameras stops", kAddTheKey),
      misreading(Code::kCvOmnidirMeant, "{0} is in the file: it is for cv::omnidir, although the caller asks for {1}"),
      refusal(Code::kCvXiNoNumber, "{0} is not a number; cv::omnidir needs one"),
      refusal(Code::kCvNoVector, "{0} is not a vector of 3 numbers"),
      refusal(Code::kCvHalfAPose, "{0} is missing next to {1}; the pose of the second camera needs both", kAddTheKey),
      refusal(Code::kCvRotationSize, "{0} is {1} x {2}; it must be a 3 x 3 matrix of floating-point numbers"),
      refusal(Code::kCvCameraCount, "{0} is {1}, but there are {2} maps camera_0 ..."),
      refusal(Code::kCvNoMap, "{0} is not a map"),
      refusal(Code::kCvKeyMissing, "{0} is missing", kAddTheKey),
      refusal(Code::kCvPoseSize, "{0} is {1} x {2}; it must be a 4 x 4 matrix of floating-point numbers"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
