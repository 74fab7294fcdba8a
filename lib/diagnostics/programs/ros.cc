// SPDX-License-Identifier: BSD-3-Clause
// What ROS reports about a file.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> ros_program_codes() {
  static constexpr std::array kRows = {
      // camera_calibration_parsers
      refusal(Code::kRosSaysNotParsed, "camera_calibration_parsers refuses the file{0}: {1}"),
      clause(Code::kRosSaysAtKey, " at {0}"),
      refusal(Code::kRosSaysMatrixSize,
              "{0} is not {1} x {2}: camera_calibration_parsers asserts that, or without asserts reads beyond its array"),
      refusal(Code::kRosSaysCoefficientsTooMany, "distortion_coefficients has a size that no memory holds"),
      refusal(Code::kRosSaysKeyMissing, "camera_calibration_parsers fails to find key '{0}' in {1}"),
      refusal(Code::kRosSaysLinesMissing, "camera_calibration_parsers reads beyond the lines of '{0}'"),
      refusal(Code::kRosSaysNoCount, "'{0}' is not a {1}"),
      refusal(Code::kRosSaysMatrixNotParsed, "camera_calibration_parsers: error parsing '{0}', incorrect size"),
      refusal(Code::kRosSaysCoefficientCount,
              "distortion has neither 5 nor 8 numbers: coefficients that are missing become nan"),
      refusal(Code::kRosSaysNoCamera, "the file contains no section of a camera"),
      // image_geometry, and OpenCV below it
      refusal(Code::kRosSaysUnknownModel,
              "image_geometry does not know distortion_model '{0}' and throws: distortion is unknown"),
      refusal(Code::kRosSaysOpenCvCount, "cv::projectPoints stops: {0} coefficients are not 4, 5, 8, 12 or 14"),
      refusal(Code::kRosSaysFisheyeCount, "cv::fisheye stops: {0} coefficients are not 4"),
      refusal(Code::kRosSaysNoFocalLength,
              "projection_matrix has a focal length of 0: every point that image_geometry computes is nan"),
      refusal(Code::kRosSaysProjectionCorner, "projection_matrix(2, 3) is not 0, which image_geometry asserts"),
      refusal(Code::kRosSaysRoiOutside, "the roi reaches beyond the image: OpenCV stops"),
      misreading(Code::kRosSaysLastCameraKept, "the file contains {0} cameras, and only the last one is kept"),
      misreading(Code::kRosSaysFisheyeOfZeros, "all coefficients are 0: image_geometry takes the camera for a pinhole"),
      misreading(Code::kRosSaysSkewUnused, "camera_matrix has a skew of {0:all} px, which image_geometry does not use"),
      misreading(Code::kRosSaysCoefficientsOfZeros,
                 "all coefficients are 0: image_geometry takes the images for rectified ones and does not apply R and P"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
