// SPDX-License-Identifier: BSD-3-Clause
// How two calibrations differ, and by which mistake. {0} of a mistake is what it is about.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kInverted = "pose-inverted";
constexpr std::string_view kTransposed = "pose-transposed";
constexpr std::string_view kMillimetres = "translation-in-mm";
constexpr std::string_view kExchanged = "cameras-exchanged";
constexpr std::string_view kHalf = "half-pixel";
constexpr std::string_view kOne = "one-pixel";
constexpr std::string_view kResolution = "other-resolution";
constexpr std::string_view kSwapped = "parameters-swapped";
constexpr std::string_view kDiscrete = "imu-noise-discrete";
constexpr std::string_view kVariance = "imu-noise-variance";

}  // namespace

std::span<const CodeInfo> comparison_codes() {
  static constexpr std::array kRows = {
      error(Code::kResolutionDiffers, "resolution-differs",
            "{0} has images of {1} x {2} px in the reference and of {3} x {4} px in the other{5}",
            "give the change from the reference's images to the other's: a crop, a binning, or a resize to {3} x {4} px"),
      clause(Code::kSidesExchanged, ": width and height are exchanged"),
      clause(Code::kNotScaled, ", and neither is the other scaled"),
      error(Code::kNothingInCommon, "nothing-to-compare",
            "the two have nothing in common: the reference holds {0}, the other {1}"),
      clause(Code::kCamerasAndImus, "{0} and {1}"),
      clause(Code::kSoMany, "{0} {1}{0:s}"),
      clause(Code::kNoSuch, "no {0}s"),

      // What only one of the two says.
      clause(Code::kOnlyThing, "{0}"),
      clause(Code::kOnlyFact, "{0} {1}"),
      clause(Code::kOnlyPose, "the pose of {0}"),
      clause(Code::kOnlyPoseBetween, "the pose of {0} to {1}"),

      // Common mistakes, in poses.
      about_poses(error(Code::kPoseHoldsInverse, kInverted,
                        "{0} holds the other direction (its inverse agrees with the other poses)",
                        "invert it: R^T and -R^T t")),
      about_poses(error(Code::kPoseTransposed, kTransposed, "{0} holds the transposed rotation",
                        "write the rotation's columns as rows")),
      about_poses(error(Code::kPoseInMillimetres, kMillimetres, "{0} has its translation in millimetres",
                        "divide the translation by 1000")),
      about_poses(error(Code::kPoseInCentimetres, kMillimetres, "{0} has its translation in centimetres",
                        "divide the translation by 100")),
      about_poses(error(Code::kPoseInHectometres, kMillimetres, "{0} has its translation 100 times too small",
                        "multiply the translation by 100, or the reference's is in centimetres")),
      about_poses(error(Code::kPoseInKilometres, kMillimetres, "{0} has its translation 1000 times too small",
                        "multiply the translation by 1000")),
      error(Code::kPoseInverted, kInverted, "{0} is the inverse of what it should be: it holds {1}"),
      error(Code::kPoseOfAnotherCamera, "pose-of-another-camera", "{0} is that of the reference's {1}"),
      error(Code::kCamerasExchanged, kExchanged, "{0} are exchanged"),
      error(Code::kIntrinsicsExchanged, kExchanged, "{0} have each other's intrinsics"),
      error(Code::kPosesExchanged, "poses-exchanged", "{0} have each other's poses"),

      // In cameras.
      error(Code::kHalfPixelTooFar, kHalf,
            "{0} has its principal point half a pixel too far to the lower right: it counts from the corner of the first "
            "pixel, not from its centre"),
      error(Code::kHalfPixelTooNear, kHalf,
            "{0} has its principal point half a pixel too far to the upper left: half a pixel was subtracted once too often"),
      error(Code::kOnePixelTooFar, kOne,
            "{0} has its principal point one pixel too far to the lower right: it counts from 1, as MATLAB does, not from 0"),
      error(Code::kOnePixelTooNear, kOne,
            "{0} has its principal point one pixel too far to the upper left: 1 was subtracted once too often"),
      error(Code::kScaledWithoutHalfPixel, "scaled-without-half-pixel",
            "{0} was scaled from the larger or smaller image as cx s; the right formula is (cx + 0.5) s - 0.5, because pixels "
            "are areas"),
      error(Code::kCentreMirrored, "centre-mirrored",
            "{0} has {1} on the other side of the image's middle: its offset from there has the other sign"),
      error(Code::kCentreSwapped, "centre-swapped", "{0} has row and column of its principal point exchanged"),
      error(Code::kOfImagesTwiceThatSize, kResolution, "{0} holds the numbers of images twice that size"),
      error(Code::kOfImagesHalfThatSize, kResolution, "{0} holds the numbers of images half that size"),
      error(Code::kOfImagesOfTheReference, kResolution, "{0} has another image size and holds the numbers of the reference's"),
      error(Code::kParametersExchanged, kSwapped, "{0} has {1} and {2} exchanged"),
      error(Code::kCoefficientsInOrder, kSwapped, "{0} has its coefficients in the order {1} under the names {2}"),
      error(Code::kUnderAnotherName, "wrong-model", "{0} holds the numbers of {1} under the name of {2}"),
      error(Code::kDistortionRemoved, "distortion-left-out", "{0} has the numbers of the reference, without its distortion"),

      // In numbers.
      error(Code::kTimeOffsetOfOtherSign, "time-offset-sign",
            "{0} has the time offset with the other sign: it should be t_imu = t_cam + offset, and it holds t_cam = t_imu + "
            "offset"),
      error(Code::kNoiseDiscrete, kDiscrete,
            "{0} holds discrete deviations (of one sample, times sqrt(rate)) where densities belong: {1:,}"),
      error(Code::kNoiseDividedByRate, kDiscrete,
            "{0} holds densities divided by sqrt(rate): they were taken for discrete deviations: {1:,}"),
      error(Code::kNoiseVariance, kVariance, "{0} holds variances (squares) where standard deviations belong: {1:,}"),
      error(Code::kNoiseOfVariances, kVariance,
            "{0} holds square roots of the densities: they were taken for variances: {1:,}"),
      error(Code::kBaselineInMillimetres, kMillimetres, "{0} is in millimetres"),
      error(Code::kBaselineTooSmall, kMillimetres, "{0} is 1000 times too small"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
