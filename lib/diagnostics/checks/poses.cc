// SPDX-License-Identifier: BSD-3-Clause
// What a check finds about poses.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kMillimetres = "translation-in-mm";
constexpr std::string_view kDivideIfSo = "divide the translation by 1000 if they are millimetres";
constexpr std::string_view kThreshold = "depth-threshold";

}  // namespace

std::span<const CodeInfo> pose_check_codes() {
  static constexpr std::array kRows = {
      about_poses(error(Code::kPoseLeftHanded, "left-handed",
                        "{0}: its 3 x 3 part mirrors (determinant -1) instead of rotating",
                        "the sign of one row or column is wrong, or two of them are exchanged")),
      about_poses(error(
          Code::kPoseNotARotation, "not-a-rotation",
          "{0}: its 3 x 3 part is not a rotation: R^T R is {1:.3} from the identity, and the nearest rotation differs by up to "
          "{2:.2} in an element",
          "copy it from the calibration's result; the nearest rotation is [{3:.7}, {4:.7}, {5:.7}], [{6:.7}, {7:.7}, {8:.7}], "
          "[{9:.7}, {10:.7}, {11:.7}]")),
      about_poses(warning(Code::kCamerasTooClose, kMillimetres,
                          "{0} is {1:.3} mm long: no two lenses are so close to each other",
                          "give the unit of the numbers, or compare the translation with the rig")),
      about_poses(warning(Code::kTranslationInMillimetres, kMillimetres,
                          "the translation of {1} is {0:.4} m long; the numbers are probably millimetres", kDivideIfSo)),
      about_poses(warning(Code::kTranslationInCentimetres, kMillimetres,
                          "the translation of {1} is {0:.4} m long; the numbers are probably centimetres or millimetres",
                          "if so, divide by 100 or 1000")),
      warning(Code::kBaselineTooLong, kMillimetres, "the baseline is {0:.4} m long; the number is probably millimetres",
              kDivideIfSo),
      warning(Code::kBaselineIsBf, "baseline-is-bf",
              "Stereo.b = {0:.5} is too long for a baseline in metres; it may be Camera.bf (baseline times fx) of a baseline "
              "of {1:.4} m",
              "write {1:.4}, the distance of the two lenses in metres"),
      warning(Code::kBaselineIsBfOrMillimetres, "baseline-is-bf",
              "Stereo.b = {0:.5} is too long for a baseline in metres; it may be Camera.bf (baseline times fx) of a baseline "
              "of {1:.4} m, or millimetres",
              "write the distance of the two lenses in metres: {1:.4}, or {2:.4} if it is millimetres"),
      about_poses(
          warning(Code::kSecondCameraIsLeft, "stereo-order",
                  "the second camera is {0} to the left of the first: the pose is inverted, or the cameras are exchanged",
                  "if the second camera is the right one, invert the pose (it takes points of camera 2 to camera 1)")),
      about_poses(warning(Code::kCameraUnderGround, "pose-inverted",
                          "{0} is {1} of the vehicle's frame; the inverse pose would put it {2}",
                          "the file needs the pose camera -> vehicle: invert the pose")),
      about_poses(
          warning(Code::kCameraNotOfACar, "pose-implausible",
                  "{0} is {1} of the vehicle's frame; the inverse pose would put it {2}, where no car has a camera either",
                  "compare the translation with the camera's position: metres from the ground under the rear axle")),
      clause(Code::kAboveGround, "{0} above the ground"),
      clause(Code::kBelowGround, "{0} below the ground"),
      clause(Code::kInMetres, "{0:.3} m"),
      clause(Code::kInMillimetres, "{0:.3} mm"),
      question(Code::kAgreementUndecided, "poses-contradict", "whether the poses agree", "one of them is not a rotation"),
      question(Code::kDirectionUndecided, "pose-inverted", "direction of {0}{1}",
               "the file contains each pose once, and the translations of a pose and of its inverse are equally long"),
      question(Code::kWrongPoseUndecided, "pose-inverted", "which of {0} is wrong",
               "a mistake in any one of them would explain why they contradict each other"),
      clause(Code::kAndTheOthers, " and the other poses"),
      about_poses(error(Code::kPosesContradict, "poses-contradict",
                        "{0} contradicts the other poses: what follows from them differs by {1:.3} deg and {2}",
                        "find out which one is right, and compute the other from it")),
      warning(Code::kBaselineContradicts, "baseline-contradicts", "Camera.bf is {0:.5}, but {1} gives {2:.5}",
              "Camera.bf is the baseline in metres times Camera.fx"),
      clause(Code::kBaselineOfP, "RIGHT.P(0, 3) = {0:.5}"),
      clause(Code::kBaselineOfPose, "the second camera's distance of {0:.4} m"),
      with_consequence(
          warning(Code::kBaselineInProduct, "bf-is-a-baseline",
                  "focal_x_baseline = {0:.4} gives a baseline of {1:.3} m; it is probably the baseline itself, in millimetres",
                  "if so, write {2:.5} (baseline in metres times fx in pixels)"),
          "Every depth is wrong by the same factor."),
      warning(Code::kBfIsABaseline, "bf-is-a-baseline",
              "Camera.bf = {0:.4} gives a baseline of {1:.3} mm; it is probably the baseline itself, in metres",
              "if so, write {2} (baseline times Camera.fx)"),
      warning(Code::kDepthThresholdNegative, kThreshold,
              "{0} = {1:.4}: no point is nearer than that, so no point counts as close",
              "write {2:real} if only the sign is wrong; upstream's examples have 35 to 60"),
      warning(Code::kDepthThresholdZero, kThreshold, "{0} = {1:.4}: no point is nearer than that, so no point counts as close",
              "write 40.0; upstream's examples have 35 to 60"),
      warning(Code::kDepthThresholdNotInBaselines, kThreshold,
              "{0} = {1:.4} is counted in baselines, not in metres; upstream's examples have 35 to 60",
              "divide the distance in metres by the baseline"),
      about_poses(error(
          Code::kPairRolled, "pair-rolled",
          "{0} and {1} are a stereo pair, but they are rolled against each other by {2:.3} deg about their optical axes",
          "turn the images of one camera upright before the calibration; or correct the rotation, if it is another pair's")),
      about_poses(
          error(Code::kPairTurned, "pair-turned", "{0} and {1} are a stereo pair, but their optical axes are {2:.3} deg apart",
                "choose two cameras that look in the same direction; or correct the rotation, if it is another pair's")),
      about_poses(warning(Code::kPairFarApart, "pair-far-apart", "{0} and {1} are a stereo pair, but they are {2:.3} m apart",
                          "compare the translation with the rig: it may be in another unit, or another pair's")),
      about_poses(error(Code::kRectificationContradicts, "rectification-contradicts",
                        "the rectification of {0} and {1} contradicts their pose by {2:.3} deg and {3:.3} mm",
                        "rectify the pair again, from that pose")),
  };
  return kRows;
}

}  // namespace fca::diagnostics
