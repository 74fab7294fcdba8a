// SPDX-License-Identifier: BSD-3-Clause
// VINS-Fusion's files, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kWhichIsRight = "check which of the two is right";
constexpr std::string_view kIntoConfiguration = "write it into VINS-Fusion's own configuration";

}  // namespace

std::span<const CodeInfo> vins_codes() {
  static constexpr std::array kRows = {
      clause(Code::kVinsDegreeFour, "camodocal's polynomial is of degree 4"),
      clause(Code::kVinsPinholeNoK3, "camodocal's PINHOLE has no k3"),
      // Camera files, as read.
      error(Code::kVinsWrongSyntax, "wrong-syntax", "camodocal's camera files are YAML with keys at the top level"),
      error(Code::kVinsTypeMissing, "missing-key",
            "there is no model_type: camodocal takes the camera for MEI, and reads 0 for every missing number",
            "write  model_type: {0:or}"),
      error(Code::kVinsTypeMisspelt, "unknown-model",
            "model_type '{0}' is not spelled {1}: camodocal then reads every number as 0 without a warning",
            "write  model_type: {1}"),
      error(Code::kVinsTypeUnknown, "unknown-model", "model_type '{0}' is not one of camodocal's: {1:or}"),
      error(Code::kVinsSizeMissing, "missing-key", "there is no {0}: camodocal reads 0", "give the image size"),
      error(Code::kVinsSectionMissing, "missing-key", "there is no {0}: camodocal reads 0 for every number in it"),
      error(Code::kVinsSectionNotAMapping, "not-a-mapping", "{0} is not a mapping of keys and numbers: camodocal reads zeros"),
      error(Code::kVinsKeyMissing, "missing-key", "{0} has no {1}: camodocal reads 0 for it", "{2}"),
      error(Code::kVinsKeysMissing, "missing-key", "{0} has no {1}: camodocal reads 0 for them", "{2}"),
      clause(Code::kVinsCoefficientsElsewhere,
             "KANNALA_BRANDT has its coefficients in projection_parameters, not in distortion_parameters"),
      clause(Code::kVinsCoefficientsByOtherNames, "k2 .. k5 are what OpenCV and Kalibr call k1 .. k4"),
      about_reader(
          warning(Code::kVinsNoParameter, "program-ignores", "{0} {1} is not a parameter of {2}: camodocal does not read it")),
      clause(Code::kVinsPolynomial, "the polynomial of degree 4"),
      about_reader(warning(Code::kVinsRationalIgnored, "program-ignores",
                           "k1, k2, p1 and p2 are 0: camodocal takes that for a lens without distortion and ignores k3 to k6",
                           "write  k1: 1.0e-12")),
      error(Code::kVinsPolynomialSign, "polynomial-sign",
            "p0 is positive: the polynomial's z points to the back of the lens, so p0 is negative",
            "change the sign of all poly_parameters and of p1, p3, .. of inv_poly_parameters"),
      error(Code::kVinsAffineMirrors, "not-a-camera",
            "ac and ac - ad ae must be positive: [ac ad; ae 1] mirrors the image or is singular"),

      // OCamCalib's inverse polynomial.
      about_reader(warning(Code::kVinsCoefficientIgnored, "program-ignores", "{0} {1} is not read: camodocal has p0 to p19")),
      warning(Code::kVinsInverseMissing, "inverse-missing",
              "there is no inv_poly_parameters: camodocal projects every point to the centre", "fit it to poly_parameters"),
      warning(Code::kVinsInverseStale, "stale-inverse",
              "inv_poly_parameters is up to {0:.3} px from the inverse of poly_parameters: projecting and unprojecting see two "
              "different lenses; fca-io uses poly_parameters",
              "fit it to poly_parameters again"),
      reader_warning(Code::kVinsInverseInexact, "inverse-inexact",
                     "{0}: no inverse polynomial of the {2} coefficients that {3} holds comes nearer to the direct one than "
                     "{1:.2} px; its projection is off by that much",
                     "leave out the border, where the direct polynomial turns; or take another model"),

      // VINS-Fusion's configuration, as read.
      error(Code::kVinsCountMissing, "missing-key", "there is no num_of_cam: VINS-Fusion stops", "write  num_of_cam: 1  or 2"),
      error(Code::kVinsCountOutOfRange, "out-of-range", "num_of_cam is {0}; VINS-Fusion takes 1 or 2"),
      error(Code::kVinsPoseMissing, "missing-key", "there is no {0}: VINS-Fusion stops"),
      error(Code::kVinsPoseOfOtherSize, "wrong-length", "{0} must be 4 x 4"),
      error(Code::kVinsNamesConfiguration, "no-calibration",
            "it names a configuration, not a camera file: camodocal finds no model_type there", "name the camera's file"),
      warning(Code::kVinsSizeContradicts, "size-contradicts",
              "the images are of {0} x {1} px here, but of {2} x {3} px in {4}; VINS-Fusion uses this size", kWhichIsRight),

      // What cannot be written, and what a configuration that is written into keeps.
      clause(Code::kVinsFilesStateSize, "camodocal's camera files contain the image size"),
      clause(Code::kVinsWantsSize, "VINS-Fusion needs the image size"),
      error(Code::kVinsSizesDiffer, "image-sizes-differ", "VINS-Fusion has one image size for both cameras, but theirs differ",
            "resize the images of one"),
      error(Code::kVinsConfigurationUnreadable, "no-calibration", "the configuration that is the base cannot be read"),
      error(Code::kVinsCameraMisplaced, "camera-misplaced",
            "a single camera becomes cam0 of the configuration, but cam1 should go into a configuration of two",
            "give both cameras, or write  num_of_cam: 1"),
      warning(Code::kVinsCameraKept, "camera-kept",
              "num_of_cam stays {0}, and {1} is the base's: VINS-Fusion reads {1}_calib's file next to the written one and "
              "stops without it",
              "put that file there, or write  num_of_cam: {2}"),
      warning(Code::kVinsOtherImages, "size-contradicts",
              "the configuration was for images of {0} x {1} px, and is now for the input's images of {2} x {3} px",
              "give the calibration of the images that the configuration is for{4}"),
      clause(Code::kVinsIfScaled, "; resize to {0} x {1} px if they are the input's, scaled"),
      note(Code::kVinsPoseKept, "pose-kept", "{0} stays as it is: no input contains the pose of {1} in the IMU"),
      note(Code::kVinsTimeOffsetKept, "time-offset-kept", "td stays {0} s: no input contains the time offset of {1}"),
      note(Code::kVinsNoiseConverted, "imu-noise-converted",
           "{0}: acc_n, gyr_n, acc_w and gyr_w are the densities times sqrt({1} Hz), which VINS-Fusion reads as one sample's "
           "noise"),
      note(Code::kVinsNoiseRead, "imu-noise-converted",
           "{0}: acc_n, gyr_n, acc_w and gyr_w are one sample's noise to VINS-Fusion; fca-io divides them by sqrt({1} Hz) to "
           "get densities"),

      // What the files cannot hold.
      loss(Code::kVinsNoiseOfUnknownRate, "imu-dropped", "the IMU's noise ({2:and})",
           "it is the noise of one sample; to compute densities, fca-io needs the IMU's rate", "give the IMU's rate"),
      loss(Code::kVinsNoiseDropped, "imu-dropped", "{0} noise",
           "acc_n, gyr_n, acc_w and gyr_w are for single samples: they need all four densities and the rate",
           "add what is missing to the IMU's file (update_rate)"),
      loss(Code::kVinsImuDropped, "imu-dropped", "{0} noise and rate", "{2}", kIntoConfiguration),
      loss(Code::kVinsSecondImuDropped, "imu-dropped", "{0} noise and rate", "VINS-Fusion has one IMU",
           "keep its file; as Kalibr's a complete IMU is a file of its own"),
      loss(Code::kVinsCameraDropped, "camera-dropped", "{0}", "VINS-Fusion uses two cameras", "choose the two"),
      loss(Code::kVinsTimeOffsetDropped, "time-offset-dropped", "{0} {1} {2:.12} s", "{3}", kIntoConfiguration),
      loss(Code::kVinsBaselineDropped, "baseline-dropped", "{1} {2} m", "{3}",
           "keep it for programs that ask for the baseline separately"),
      clause(Code::kVinsFilesHaveNoPlace, "files of camodocal have no place for it"),
      clause(Code::kVinsCameraFilesHaveNoPlace, "camodocal's camera files have no place for it"),
      clause(Code::kVinsConfigurationHasNoPlace, "VINS-Fusion's configuration has no place for it"),
      clause(Code::kVinsHasOneTd, "VINS-Fusion has one td for both cameras"),
      clause(Code::kVinsImuTopicNotTouched, "imu_topic stays unchanged"),

      // Headlines, and what to do.
      clause(Code::kVinsCameraFile, "a camera file for VINS-Mono and VINS-Fusion"),
      clause(Code::kVinsCameraFiles, "one camera file per camera for VINS-Mono and VINS-Fusion"),
      clause(Code::kVinsConfiguration, "VINS-Fusion's configuration and the camera files that it names"),
      clause(Code::kVinsIntoConfiguration, kIntoConfiguration),
  };
  return kRows;
}

}  // namespace fca::diagnostics
