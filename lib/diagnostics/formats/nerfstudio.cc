// SPDX-License-Identifier: BSD-3-Clause
// transforms.json of nerfstudio and instant-ngp, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kNoLens = "fca-io has no such camera model.";
constexpr std::string_view kOfTwo = "nerfstudio and instant-ngp may see different lenses.";

}  // namespace

std::span<const CodeInfo> nerf_codes() {
  static constexpr std::array kRows = {
      // What speaks for the format.
      clause(Code::kNerfFound, "frames or an intrinsic with {0}"),

      // Read.
      error(Code::kNerfWrongSyntax, "wrong-syntax", "a transforms.json is one JSON object"),
      error(Code::kNerfFramesNoList, "not-a-list", "frames is not a list", "write an object for each image"),
      error(Code::kNerfFrameNoObject, "not-a-mapping", "frame {0} is not an object of keys and values"),
      with_consequence(error(Code::kNerfUnknownModel, "unknown-model", "nerfstudio has no camera_model {0}", "{1:or}"),
                       "nerfstudio stops here."),
      error(Code::kNerfModelNotRead, "unknown-model", "fca-io does not read cameras of nerfstudio's camera_model {0}: {1}",
            "calibrate with OPENCV or OPENCV_FISHEYE"),
      error(Code::kNerfLensNotRead, "unknown-model", "{0} chooses a lens of instant-ngp that fca-io does not read: {1}",
            "calibrate with k1, k2, p1, p2, or with is_fisheye and k1 to k4"),
      clause(Code::kNerfStereo, "its rays do not meet in one point"),
      clause(Code::kNerfOrthographic, "its rays are parallel"),
      clause(Code::kNerfFisheye624, "fca-io reads that lens only in COLMAP's files (RAD_TAN_THIN_PRISM_FISHEYE)"),
      clause(Code::kNerfFtheta, "it has no model with the angle as a polynomial of pixels"),
      error(Code::kNerfNoBool, "out-of-range", "is_fisheye is {0}; it must be true or false"),
      warning(Code::kNerfTwoLenses, "model-contradicts",
              "camera_model is {0}, but is_fisheye is {1}: nerfstudio uses the former, instant-ngp the latter",
              "make is_fisheye agree with camera_model"),
      with_consequence(
          warning(Code::kNerfTwoValues, "duplicate-key",
                  "{0} is {1} here and {2} at the top: nerfstudio takes the top's, instant-ngp the frame's (but no list)",
                  "remove one of the two"),
          kOfTwo),
      with_consequence(
          warning(Code::kNerfListContradicts, "duplicate-key",
                  "{0} is {1} here and {2} in distortion_params: nerfstudio takes the latter, instant-ngp the former",
                  "remove one of the two"),
          kOfTwo),
      warning(Code::kNerfDigitOne, "key-misspelt", "{0} begins with a digit 1 in place of an l: no program reads it",
              "write {1}"),
      error(Code::kNerfNoFocalLength, "missing-key", "{0} has no focal length: there is neither fl_x nor camera_angle_x",
            "write fl_x and fl_y, in pixels"),
      error(Code::kNerfAngle, "out-of-range", "{0} is {1}, but an image without distortion spans 0 to {2}"),
      error(Code::kNerfNeedsSize, "missing-key", "{0} depends on the image's size, but there is no w and h",
            "write w and h, in pixels"),
      with_consequence(
          error(Code::kNerfQuartic, "unknown-model", "k4 is {0}: for a lens that is not a fisheye, it multiplies r^8"),
          kNoLens),
      with_consequence(error(Code::kNerfTangential, "unknown-model", "{0} is {1} next to the coefficients of a fisheye"),
                       kNoLens),

      // Written.
      error(Code::kNerfKindsDiffer, "unknown-model",
            "{0} is a fisheye and {1} is not, but a transforms.json has one camera_model for all cameras",
            "write one file for each, or choose one model"),
      clause(Code::kNerfDemandsSize, "a transforms.json contains the size of its images"),
      clause(Code::kNerfNoPlace, "a transforms.json has no place for it"),
      clause(Code::kNerfFramesToAdd, "of your images with their poses, in place of one for each camera"),
      clause(Code::kNerfTinyCoefficient, "{0}, not 0: instant-ngp takes a fisheye without coefficients for a pinhole"),
      clause(Code::kNerfHeadline, "a transforms.json for nerfstudio and instant-ngp"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
