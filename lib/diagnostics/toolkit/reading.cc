// SPDX-License-Identifier: BSD-3-Clause
// Messages about inputs.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> reading_codes() {
  static constexpr std::array kRows = {
      bad_request(Code::kUnknownCamera, "unknown-camera", "there is no camera '{0}'; the calibration has {1}"),
      bad_request(Code::kCameraTwice, "unknown-camera", "camera '{0}' is chosen twice"),
      warning(Code::kPartMissing, "part-missing", "the file names {0}, which cannot be read: its cameras are unknown",
              "put that file there"),
      bad_request(Code::kUnitWithoutUse, "option-without-use",
                  "a unit of lengths is only for formats without a fixed unit; this one ({0}) is in metres"),
      error(Code::kGivenSizeContradicts, "size-contradicts", "{0} has {1} x {2} px in the file, but {3} x {4} px are given",
            "give a size only for files that contain none"),
      error(Code::kImageOfOtherSize, "image-size", "the image is {0} x {1} px, but {2} is calibrated for {3} x {4} px", "{5}"),
      clause(Code::kGiveCalibratedSize, "give the images of the calibrated size"),
      clause(Code::kSayWhatWasDone, "give only the changes that were made to these images"),
      clause(Code::kIfScaled, "if it is the calibrated image, scaled: give its new size, {0} x {1} px"),
      clause(Code::kIfPart, "if it is a part of the calibrated image: give where its {0} x {1} px begin"),
      bad_request(Code::kFilesWithoutImages, "no-image", "these files hold no images"),

      // Images that were changed.
      note(Code::kImagesChanged, "images-changed", "{0}: {1:then}, from {2} x {3} px: {4}, {5}"),
      clause(Code::kCropStep, "crop {0} x {1} px at ({2}, {3})"),
      clause(Code::kBinningStep, "binning {0}"),
      clause(Code::kResizeStep, "resize to {0} x {1} px"),
      clause(Code::kAxisMap, "{0}' = {1} {0} {2} {3}"),

      // The IMU's noise.
      bad_request(Code::kNoiseWithoutImu, "imu-missing", "a kind of IMU noise is given, but the input has no IMU",
                  "also give the IMU's file"),
      error(Code::kNoiseWithoutRate, "imu-rate-missing", "{0} noise needs the rate of {1}, and no input contains it",
            "add update_rate to the IMU's file"),
      bad_request(Code::kRateWithoutImu, "imu-missing", "a rate of the IMU is given, but the input has no IMU",
                  "also give the IMU's file"),
      error(Code::kRateContradicts, "imu-rate", "{0} has {1} Hz in the file, but {2} Hz are given",
            "give a rate only for files that contain none"),
      note(Code::kDensitiesMade, "imu-noise-converted", "{0}: the noise is converted to densities ({1})"),
      clause(Code::kRootsOfVariances, "square roots of the variances"),
      clause(Code::kRootsThenRate, "square roots of the variances, then {0}"),
      clause(Code::kByRate, "white noise / sqrt(rate), random walks * sqrt(rate), rate {0} Hz"),

      // Lens circles.
      bad_request(Code::kCircleWithoutImage, "no-image", "no image is named for the image circle '{0}'", "name one"),
      bad_request(Code::kCircleOfNoCamera, "lens-circle-of-none", "the image {0} is not assigned to a camera", "cameras: {1}"),
      bad_request(Code::kCircleOfUnknownCamera, "lens-circle-of-none",
                  "the image {0} is assigned to a camera '{3}', which does not exist", "cameras: {1}"),
      warning(Code::kCircleOffCentre, "lens-circle-off-centre",
              "{0}: the image circle's centre is {1:.1f} px from the principal point",
              "check that it is this camera's lens and not a lamp; a report draws it"),
      warning(Code::kCircleSmall, "lens-circle-small", "{0}: the image circle covers only {1:%} of the image",
              "check that it is this camera's lens and not something bright in front of it; a report draws it"),
      warning(Code::kCircleUncertain, "lens-circle-uncertain",
              "{0}: only {1:%} of the image circle's rim in the image was found",
              "check that it is a lens's edge; a report draws it, and further images of brighter scenes show more of it"),
      warning(Code::kCirclesDiffer, "lens-circles-differ",
              "{0}: this image shows another image circle (centre ({1:.1f}, {2:.1f}), radius {3:.1f} px) than {4}",
              "check that it is of this camera; it is left out"),
      clause(Code::kImagesByName, "{0}"),
      clause(Code::kImagesByNumber, "{0} image{0:s}"),
      clause(Code::kImageCircleOf, "the image circle of {0}"),
      warning(Code::kImageWithoutCircle, "no-lens-circle",
              "{0}: the image shows no dark border around an image circle about the principal point; the whole image counts as "
              "lens",
              "give images of a bright scene, or several images; or give the angle at which the lens ends"),
      warning(Code::kImagesWithoutCircle, "no-lens-circle",
              "{0}: the images show no dark border around an image circle about the principal point; the whole image counts as "
              "lens",
              "give images of a bright scene, or several images; or give the angle at which the lens ends"),
      warning(Code::kCircleInStretchedImages, "lens-circle-stretched",
              "{0}: in images stretched along one side, the image circle is not a circle; the whole image counts",
              "give images of the calibrated size"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
