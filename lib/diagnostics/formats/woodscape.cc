// SPDX-License-Identifier: BSD-3-Clause
// WoodScape's files, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

/// An error of intrinsic and a warning of the pose, which other programs do without.
constexpr CodeInfo key_error(Code code, std::string_view text) {
  return {.code = code, .id = "missing-key", .severity = Severity::kError, .about = About::kReader, .text = text};
}

constexpr std::string_view kNotInPixels = "not-in-pixels";
constexpr std::string_view kNotARotation = "not-a-rotation";

}  // namespace

std::span<const CodeInfo> woodscape_codes() {
  static constexpr std::array kRows = {
      clause(Code::kWoodscapeJsonInPixels, "k1 counts pixels per radian"),
      // What speaks for the format.
      clause(Code::kWoodscapeJsonWithKey, "intrinsic with {0}"),
      clause(Code::kWoodscapeJsonWithQuaternion, "intrinsic with k1 next to an extrinsic with quaternion"),

      error(Code::kWoodscapeJsonOneObject, "wrong-syntax", "a WoodScape calibration is one JSON object"),
      key_error(Code::kWoodscapeJsonMissing, "there is no {0}: projection.py stops with KeyError: '{0}'{1}"),
      key_error(Code::kWoodscapeJsonNoObject,
                "{0} is not an object of keys and values: projection.py stops with KeyError: '{0}'{1}"),
      key_error(Code::kWoodscapeJsonMissingKey, "{0} has no {1}: projection.py stops with KeyError: '{1}'{2}"),
      clause(Code::kWoodscapeJsonPoseNotKnown, "; the pose is not known"),
      error(Code::kWoodscapeJsonOtherModel, "unknown-model",
            "model is '{0}'; fca-io reads WoodScape's \"radial_poly\" (rho = k1 theta + ... + k4 theta^4)"),
      error(Code::kWoodscapeJsonOtherOrder, "unknown-model",
            "poly_order is {0}; projection.py reads k1 to k4, whatever this number is",
            "write the coefficients as k1 to k4 and poly_order as 4"),
      error(Code::kWoodscapeJsonPerDegree, kNotInPixels,
            "k1 = {0} is too small for pixels per radian (the dataset's are 200 to 600): the file probably holds pixels per "
            "degree ({0} per degree are {1:.4} per radian)",
            "multiply k1 .. k4 by 57.29578 to the power of 1 .. 4"),
      error(Code::kWoodscapeJsonKannalaBrandt, kNotInPixels,
            "k1 = {0} is too small for pixels per radian (the dataset's are 200 to 600): the file probably holds normalised "
            "Kannala-Brandt coefficients (theta + k1 theta^3 + ...) under WoodScape's names",
            "if so, the focal length is missing here; write the camera as Kalibr's pinhole-equidistant"),
      CodeInfo{.code = Code::kWoodscapeJsonReadByNobody,
               .id = "program-ignores",
               .severity = Severity::kWarning,
               .about = About::kReader,
               .text = "no program reads {0}: projection.py takes k1 to k4"},
      error(Code::kWoodscapeJsonQuaternionZero, kNotARotation, "the quaternion is 0: scipy stops with ValueError"),
      about_poses(error(Code::kWoodscapeJsonQuaternionLength, kNotARotation, "the quaternion has length {0:.4}, not 1",
                        "a rotation by an angle a about the axis n is [n sin(a/2), cos(a/2)]")),
      about_poses(warning(Code::kWoodscapeJsonQuaternionNormalised, kNotARotation,
                          "the quaternion has length {0:.4}, not 1; projection.py normalises it",
                          "divide its four numbers by that length")),
      CodeInfo{.code = Code::kWoodscapeJsonCarla,
               .id = "carla-translation",
               .severity = Severity::kWarning,
               .about = About::kReader,
               .text = "the file has SynWoodScape's translation in CARLA's frame instead of \"{0}\": projection.py stops with "
                       "KeyError: '{0}'. CARLA is left-handed with another origin, and the published files differ in the order "
                       "of y and z, so fca-io leaves the pose out",
               .fix = "add \"{0}\": [x, y, z] of the camera in the vehicle (metres; x forward, y left, z up)"},

      clause(Code::kWoodscapeJsonCentreFromMiddle, "WoodScape counts the centre from the middle of the image"),
      clause(Code::kWoodscapeJsonNoPlace, "a WoodScape JSON has no place for it"),
      clause(Code::kWoodscapeJsonHalfAPose, "it is half a pose: quaternion and translation in the vehicle are not together"),
      clause(Code::kWoodscapeJsonPoseMadeUp, "{0}: the vehicle is not in the input, and projection.py stops without it"),
      clause(Code::kWoodscapeJsonHeadline, "a WoodScape JSON for projection.py"),
      clause(Code::kWoodscapeJsonHeadlineEach, "one WoodScape JSON per camera for projection.py"),
      clause(Code::kWoodscapeJsonHeadlineNoPose, "a WoodScape JSON without the pose that projection.py wants"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
