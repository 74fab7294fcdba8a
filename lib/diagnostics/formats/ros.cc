// SPDX-License-Identifier: BSD-3-Clause
// ROS camera_info files, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kAloneTheIdentity = "for a camera that is not part of a stereo pair, write the identity";
constexpr std::string_view kAloneItsMatrix =
    "for a camera that is not part of a stereo pair, write camera_matrix with a column of zeros";

}  // namespace

std::span<const CodeInfo> ros_codes() {
  static constexpr std::array kRows = {
      clause(Code::kRosDemandsSize, "ROS needs a size"),
      // The file and its keys.
      error(Code::kRosNoMapping, "wrong-syntax", "a camera_info is a mapping of keys and values"),
      error(Code::kRosOneFile, "wrong-syntax", "a camera_info is one file"),
      reader_warning(Code::kRosKeyMissing, "missing-key", "there is no {0}: ROS's parser refuses the file", "add it"),
      clause(Code::kRosMessage, "a printed CameraInfo message: K and P as lists"),
      reader_warning(Code::kRosRectificationMissing, "missing-key",
                     "there is no rectification_matrix: ROS's parser refuses the file", kAloneTheIdentity),
      reader_warning(Code::kRosProjectionMissing, "missing-key", "there is no projection_matrix: ROS's parser refuses the file",
                     kAloneItsMatrix),
      error(Code::kRosNotAMatrix, "not-a-matrix", "{0} is not a mapping of rows, cols and data"),
      error(Code::kRosMatrixSize, "wrong-length", "{0} is {1} x {2}; ROS's parser wants {3} x {4}"),
      error(Code::kRosBinningImpossible, "out-of-range", "{0} is {1}; that is not a possible binning",
            "write how many pixels become one, or 0 for none"),
      error(Code::kRosRoiNoMapping, "not-a-mapping", "roi has no x_offset, y_offset, width and height"),
      error(Code::kRosRoiNegative, "out-of-range", "roi {0} is {1}"),
      error(Code::kRosRoiOutside, "out-of-range",
            "the roi of {0} x {1} pixels at ({2}, {3}) does not lie in an image of {4} x {5}",
            "write zeros for the whole image"),
      error(Code::kRosNoPixelLeft, "image-size-invalid", "after binning, no pixel of the image is left"),
      error(Code::kRosCameraTwice, "stated-twice", "the camera {0} is here and earlier"),
      // An .ini.
      warning(Code::kRosIniNoImage, "missing-key",
              "there is no section [image] before the camera: ROS assumes an image of 0 x 0 pixels",
              "add [image] with width and height"),
      error(Code::kRosIniNoCamera, "missing-key", "the file has no section of a camera: [name], camera matrix, ..."),
      reader_warning(Code::kRosIniManyCameras, "program-misreads",
                     "the file contains {0} cameras, but ROS's parser keeps only the last",
                     "write each camera into a file of its own"),
      error(Code::kRosIniKeyMissing, "missing-key", "the section {0} has no {1}"),
      error(Code::kRosIniRowLength, "wrong-length", "{0}, row {1}: {2} numbers; it must be {3}, in {4} rows"),
      error(Code::kRosIniCoefficientCount, "wrong-length",
            "distortion has {0} numbers; plumb_bob has 5, rational_polynomial 8, and ROS's parser reads missing ones as nan"),
      // camera_matrix
      error(Code::kRosMatrixTransposed, "matrix-transposed",
            "camera_matrix is transposed: its principal point is in the last row", "write fx 0 cx, 0 fy cy, 0 0 1 row by row"),
      about_reader(
          error(Code::kRosPairVertical, "stereo-vertical",
                "{0} sits {1:.3} cm {2} the other camera of its pair (projection_matrix(1, 3)), and stereo_image_proc looks "
                "for matches along the rows only",
                "turn both images by 90 deg and calibrate those; each image alone is rectified correctly")),
      reader_warning(Code::kRosSkewKept, "skew",
                     "camera_matrix has a skew of {0} px at (0, 1), which is a part of the camera; image_geometry ignores it",
                     "write 0 there if all programs that use the file ignore it"),
      error(Code::kRosNotACameraMatrix, "not-a-camera-matrix", "camera_matrix has {0} where a camera matrix has 0"),
      warning(Code::kRosMatrixCorner, "matrix-corner", "camera_matrix(2, 2) is {0}, not 1", "write 1.0"),
      // The lens.
      warning(Code::kRosModelAssumed, "key-assumed",
              "there is no distortion_model: ROS's parser takes plumb_bob, with a warning of its own",
              "add  distortion_model: plumb_bob"),
      error(Code::kRosUnknownModel, "unknown-model",
            "image_geometry does not know the distortion_model '{0}' (only plumb_bob, rational_polynomial, equidistant): it "
            "throws at the first point or image",
            "convert the camera from the file of the program that made it"),
      error(Code::kRosModelMisspelt, "unknown-model",
            "image_geometry does not know the distortion_model '{0}' (only plumb_bob, rational_polynomial, equidistant)",
            "did you mean {1:or}?"),
      reader_warning(Code::kRosModelOfOthers, "program-refuses",
                     "image_geometry does not know the distortion_model '{0}' (only plumb_bob, rational_polynomial, "
                     "equidistant): it throws at the first point or image; read as {1}",
                     "write {1}"),
      error(Code::kRosFisheyeCount, "wrong-length",
            "distortion_coefficients has {0} numbers; equidistant has k1 k2 k3 k4, and cv::fisheye stops at any other count"),
      error(Code::kRosOpenCvCount, "wrong-length",
            "distortion_coefficients has {0} numbers; cv::projectPoints, which image_geometry calls, takes 4, 5, 8, 12 or 14"),
      reader_warning(
          Code::kRosRationalUnderPlumbBob, "program-ignores",
          "plumb_bob has 5 coefficients, but here are {0}: image_geometry computes rational_polynomial, whatever the name",
          "write  distortion_model: rational_polynomial"),
      reader_warning(Code::kRosFisheyeOfZeros, "program-misreads",
                     "all coefficients are 0, which image_geometry takes for no distortion at all: a pinhole, not equidistant",
                     "write a coefficient without effect that is not 0, such as k4 = 1.0e-12"),
      reader_warning(Code::kRosCoefficientsOfZeros, "program-misreads",
                     "all coefficients are 0, which image_geometry takes for images that are rectified already: it applies "
                     "neither rectification_matrix nor projection_matrix to them",
                     "write a coefficient without effect that is not 0, such as k1 = 1.0e-12"),
      // rectification_matrix and projection_matrix
      reader_warning(Code::kRosRectificationOfZeros, "program-misreads",
                     "rectification_matrix is all 0: every rectified point is nan", kAloneTheIdentity),
      reader_warning(Code::kRosProjectionOfZeros, "program-refuses",
                     "projection_matrix is all 0: image_geometry divides by its focal length, and every point is nan",
                     kAloneItsMatrix),
      reader_warning(Code::kRosProjectionNoFocalLength, "program-refuses",
                     "projection_matrix has a focal length of 0: image_geometry divides by it", kAloneItsMatrix),
      reader_warning(Code::kRosProjectionLastRow, "program-refuses",
                     "projection_matrix(2, {0}) is {1}, not {2}: image_geometry does not compute with such a camera",
                     "write 0 0 1 0 as the last row"),
      // As written.
      error(Code::kRosIniHasNoModel, "model-not-storable", "{0}: an .ini of ROS has no {1} model",
            "name the file .yaml, which holds it, or convert the camera to radtan"),
      loss(Code::kRosCameraRenamed, "camera-renamed", "{1} {0}",
           "an .ini would take it for something else: the section is [{2}]", "name the file .yaml, which holds every name"),
      clause(Code::kRosHasNoPlace, "a camera_info has no place for it"),
      clause(Code::kRosAnotherSyntax, "another syntax is written"),
      clause(Code::kRosWroteCamera, "a camera_info for ROS"),
      clause(Code::kRosWroteCameras, "one camera_info per camera for ROS"),
      clause(Code::kRosWroteNoPair,
             "one camera_info per camera for ROS; {0} and {1} are not a pair, because one is above the other and "
             "stereo_image_proc matches along rows"),
      clause(Code::kRosWrotePair,
             "camera_info files for ROS; {3} and {4} are a pair (rectified to fx = fy = {0}, cx = {1}, cy = {2})"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
