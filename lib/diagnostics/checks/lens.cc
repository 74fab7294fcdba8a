// SPDX-License-Identifier: BSD-3-Clause
// What a check finds about lenses and images.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kFamily = "wrong-family";
constexpr std::string_view kFocalLength = "focal-length-not-in-pixels";
constexpr std::string_view kFolds = "folds-inside-image";
constexpr std::string_view kUndistortion = "undistortion-inexact";

constexpr std::string_view kOffAtTheBorder = "Directions at the border are off by tens of degrees.";
constexpr std::string_view kNameTheFisheye = "if the four numbers are k1 k2 k3 k4 of a fisheye, name that model";
constexpr std::string_view kFocalLengthAndWidth = "{0}: a focal length of {1:.5} px does not fit an image of {2} columns";
constexpr std::string_view kNoRay =
    "{0}: the radius stops growing {1:.4} deg from the axis, about {2:.4} px from the principal point: {3:.3} % of the image "
    "has "
    "no ray";
constexpr std::string_view kUndistorted =
    "{0}: cv::undistortPoints stops after five steps and is off by up to {1:.3} px; it is off by more than {2:.2} px beyond "
    "{3:.3} px from the principal point";

}  // namespace

std::span<const CodeInfo> lens_check_codes() {
  static constexpr std::array kRows = {

      with_consequence(warning(Code::kTangentialTooLarge, kFamily,
                               "{0}: {1} = {2:.4} is too large for a tangential term (real lenses: below 0.01); it may be k3 "
                               "or k4 of an equidistant (Kannala-Brandt) model",
                               kNameTheFisheye),
                       "Straight lines bend sideways and pixels far from the centre are off by tens of pixels."),
      with_consequence(warning(Code::kTangentialOfNoLens, "tangential-too-large",
                               "{0}: {1} = {2:.4} is too large for a tangential term (real lenses: below 0.01), and the other "
                               "numbers are not a fisheye's: the calibration is poor",
                               "calibrate with more views, and with targets up to the border"),
                       "Straight lines bend sideways and pixels far from the centre are off by tens of pixels."),
      with_consequence(warning(Code::kRectilinearTooWide, kFamily,
                               "{0}: nearly no distortion (k1 = {1:.3}), but {2:.4} deg across the image: no real lens does "
                               "that; the numbers are probably of an equidistant (Kannala-Brandt) model",
                               kNameTheFisheye),
                       kOffAtTheBorder),
      with_consequence(warning(Code::kRadtanUnderEquidistant, kFamily,
                               "{0}: k1 = {1:.4} and k2 = {2:.4}, with k3 and k4 near 0, look like k1 k2 p1 p2 of a "
                               "radial-tangential lens, not like an equidistant lens",
                               "if so, name the model radtan (plumb_bob, PinHole)"),
                       kOffAtTheBorder),
      with_consequence(warning(Code::kMeiUnderRadtan, kFamily,
                               "{0}: k2 = {2:.4} outweighs k1 = {1:.4} and moves the corner outwards by {3:.3} %, which no "
                               "radial-tangential lens does; a unified model (omni, MEI) has such numbers next to its xi",
                               "if so, name that model and give its xi"),
                       kOffAtTheBorder),
      warning(Code::kCoefficientRepeated, "coefficient-repeated", "{0}: {1} and {2} are the same number to the last digit, {3}",
              "one was probably copied over the other: compare them with the calibration's result"),
      error(Code::kSizeSwapped, "size-swapped",
            "{0}: the principal point ({1:.5}, {2:.5}) is the middle of a {4} x {3} image, not of one of {3} x {4}",
            "exchange width and height, or the two numbers of the principal point"),
      error(Code::kSizeUnlikeCentre, "size-unlike-centre",
            "{0}: the principal point ({1:.5}, {2:.5}) is the middle of an image {5:.3} times as large as {3} x {4}",
            "write the size of the images that were calibrated, or scale the intrinsics to this size"),
      warning(Code::kCentreOff, "centre-off",
              "{0}: the principal point ({1:.5}, {2:.5}) is far from the middle of the {3} x {4} image",
              "this is right for a cropped image; otherwise the numbers are of another resolution, or the calibration is poor"),
      error(Code::kCentreOutsideImage, "centre-outside",
            "{0}: the principal point ({1:.5}, {2:.5}) lies outside the {3} x {4} image",
            "check for exchanged numbers or another resolution; a crop also moves it, by the crop's corner"),
      error(Code::kFocalLengthTooShort, kFocalLength, kFocalLengthAndWidth,
            "write it in pixels: divide millimetres by the pixel pitch, or multiply a normalised focal length by the width"),
      error(Code::kFocalLengthTooLong, kFocalLength, kFocalLengthAndWidth, "check the focal length and the image size"),
      warning(Code::kFocalLengthsUnlike, "focal-lengths-differ", "{0}: the focal lengths {1} and {2} px differ by {3:.3} %",
              "this is right for pixels that are not square; otherwise compare both with the calibration's result"),
      error(Code::kSizeGivenDiffers, "size-contradicts", "{0} has {1} x {2} px in the file, but {3} x {4} px are given",
            "give the size only for a file that contains none"),
      question(Code::kImageNotEvaluated, kFolds, "{0}: principal point, field of view and folding",
               "the file contains no image size"),
      warning(Code::kFoldsInImage, kFolds, kNoRay,
              "calibrate with targets in the corners, or with a fisheye model; or do not use those pixels"),
      with_consequence(
          note(Code::kFoldsAtCircle, kFolds, kNoRay, "if the lens covers those pixels, calibrate with targets near the border"),
          "Nothing, if those pixels are black; a ray beyond that angle lands on a wrong pixel."),
      with_consequence(
          note(Code::kSecondSphere, "not-a-camera", "{0}: xi is {1}; for real lenses, Double Sphere's xi lies between -1 and 1",
               "this is right for a fit to another model; otherwise check whether it is omni's xi, or an alpha"),
          "Nothing: the formulas also hold for such a xi."),
      warning(Code::kOcamA1NotZero, "a1-not-zero",
              "{0}: a1 = {1:.4}, but OCamCalib always writes 0: these are not its coefficients, or not in its order (a0 first)",
              "write the coefficients in ascending order: a0 0 a2 a3 a4"),
      warning(Code::kUndistortionFewSteps, kUndistortion, kUndistorted,
              "give it more steps: cv::TermCriteria(cv::TermCriteria::COUNT, 100, 0)"),
      warning(Code::kUndistortionDiverges, kUndistortion, kUndistorted,
              "its iteration does not converge there: undistort with another solver, or leave those pixels out"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
