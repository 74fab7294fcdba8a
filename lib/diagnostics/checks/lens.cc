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
constexpr std::string_view kFocalLengthAndWidth = "{0}: the focal length {1:.5} px does not belong to an image of {2} columns";
constexpr std::string_view kNoRay =
    "{0}: the radius stops growing {1:.4} deg from the axis, about {2:.4} px from the principal point: {3:.3} % of the image "
    "has "
    "no ray";
constexpr std::string_view kUndistorted =
    "{0}: cv::undistortPoints, with its five steps, is off by up to {1:.3} px, and by more than {2:.2} px {3:.3} px from the "
    "principal point on";

}  // namespace

std::span<const CodeInfo> lens_check_codes() {
  static constexpr std::array kRows = {

      with_consequence(
          warning(Code::kTangentialTooLarge, kFamily,
                  "{0}: {1} = {2:.4} is no tangential distortion of a real lens (below 0.01); k3 and k4 of an equidistant "
                  "(Kannala-Brandt) model often stand there",
                  kNameTheFisheye),
          "Straight lines bend sideways and pixels far from the centre are off by tens of pixels."),
      with_consequence(
          warning(Code::kTangentialOfNoLens, "tangential-too-large",
                  "{0}: {1} = {2:.4} is no tangential distortion of a real lens (below 0.01), and the other numbers are of no "
                  "fisheye: a poor calibration",
                  "calibrate with more views, and with targets up to the border"),
          "Straight lines bend sideways and pixels far from the centre are off by tens of pixels."),
      with_consequence(
          warning(Code::kRectilinearTooWide, kFamily,
                  "{0}: nearly no distortion (k1 = {1:.3}) at {2:.4} deg across the image: no such lens is built; an "
                  "equidistant (Kannala-Brandt) model has such numbers",
                  kNameTheFisheye),
          kOffAtTheBorder),
      with_consequence(
          warning(Code::kRadtanUnderEquidistant, kFamily,
                  "{0}: k1 = {1:.4}, k2 = {2:.4} next to k3 and k4 of nearly 0 are a radial-tangential lens's k1 k2 p1 p2, not "
                  "an equidistant one's",
                  "if so, name the model radtan (plumb_bob, PinHole)"),
          kOffAtTheBorder),
      with_consequence(
          warning(Code::kMeiUnderRadtan, kFamily,
                  "{0}: k2 = {2:.4} outweighs k1 = {1:.4} and pulls the corner outwards by {3:.3} %: no plain lens does; the "
                  "numbers of a unified model (omni, MEI), which are next to its xi, look so",
                  "if so, name that model and give its xi"),
          kOffAtTheBorder),
      warning(Code::kCoefficientRepeated, "coefficient-repeated", "{0}: {1} and {2} are the same number to the last digit, {3}",
              "one was copied to the other's place: look into the calibration's result"),
      error(Code::kSizeSwapped, "size-swapped",
            "{0}: the principal point ({1:.5}, {2:.5}) is the middle of a {4} x {3} image, not of one of {3} x {4}",
            "exchange width and height, or the two numbers of the principal point"),
      error(Code::kSizeUnlikeCentre, "size-unlike-centre",
            "{0}: the principal point ({1:.5}, {2:.5}) is the middle of an image {5:.3} times as large as {3} x {4}",
            "write the size of the images that were calibrated, or scale the intrinsics to this size"),
      warning(Code::kCentreOff, "centre-off",
              "{0}: the principal point ({1:.5}, {2:.5}) is far from the middle of the {3} x {4} image",
              "right for a cropped image; else another resolution's numbers, or a poor calibration"),
      error(Code::kCentreOutsideImage, "centre-outside",
            "{0}: the principal point ({1:.5}, {2:.5}) lies outside the {3} x {4} image",
            "a crop moves it by the crop's corner; an exchange of numbers or another resolution is more likely"),
      error(Code::kFocalLengthTooShort, kFocalLength, kFocalLengthAndWidth,
            "it is in pixels: millimetres divided by the pixel pitch, or a normalised one times the width"),
      error(Code::kFocalLengthTooLong, kFocalLength, kFocalLengthAndWidth, "check it and the image size"),
      warning(Code::kFocalLengthsUnlike, "focal-lengths-differ", "{0}: the focal lengths {1} and {2} px differ by {3:.3} %",
              "right for pixels that are not square; else compare both with the calibration's result"),
      error(Code::kSizeToldDiffers, "size-contradicts", "{0} has {1} x {2} px in the file, and {3} x {4} was told",
            "give the size only for a file that contains none"),
      question(Code::kImageNotJudged, kFolds, "{0}: principal point, field of view and folding", "no image size in the file"),
      warning(Code::kFoldsInImage, kFolds, kNoRay,
              "calibrate with targets in the corners, or with a fisheye model; or do not use those pixels"),
      with_consequence(
          note(Code::kFoldsAtCircle, kFolds, kNoRay, "if the lens sees there, calibrate with targets near the border"),
          "Nothing, if those pixels are black; a ray beyond that angle lands on a wrong pixel."),
      with_consequence(
          note(Code::kSecondSphere, "not-a-camera", "{0}: xi is {1}; Double Sphere's of real lenses lies between -1 and 1",
               "right for a fit to another model; else: is it xi of omni, or alpha of another list?"),
          "The formulas hold there, too."),
      warning(Code::kOcamA1NotZero, "a1-not-zero",
              "{0}: a1 = {1:.4}; OCamCalib's fit makes it 0, so that these are not its coefficients in its order (a0 first)",
              "write the coefficients ascending: a0 0 a2 a3 a4"),
      warning(Code::kUndistortionFewSteps, kUndistortion, kUndistorted,
              "give it more steps: cv::TermCriteria(cv::TermCriteria::COUNT, 100, 0)"),
      warning(Code::kUndistortionDiverges, kUndistortion, kUndistorted,
              "its iteration never arrives there: undistort with another solver, or leave those pixels out"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
