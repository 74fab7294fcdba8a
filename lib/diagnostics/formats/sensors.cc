// SPDX-License-Identifier: BSD-3-Clause
// EuRoC's sensor.yaml and Kimera-VIO's CameraParams and ImuParams, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> sensor_codes() {
  static constexpr std::array kRows = {
      // Read.
      warning(Code::kEurocFisheye, "program-ignores",
              "{0}: camera_model {1} makes the coefficients equidistant, whatever distortion_model ({2}) is",
              "write camera_model: pinhole and distortion_model: equidistant, which every other reader understands"),
      error(Code::kKimeraOmni, "unknown-model", "{0}: fca-io does not read cameras of camera_model {1}",
            "convert the calibration that it was made from"),
      warning(Code::kKimeraRateNotWhole, "program-misreads", "{0} is {1}, and Kimera-VIO reads it as the int {2}",
              "write a whole number"),

      // Written: what stands against it.
      clause(Code::kEurocNoK3, "radial-tangential has no k3 in a sensor.yaml"),

      // Written: losses and their reasons.
      clause(Code::kEurocImuDemands, "the sensor.yaml of an IMU also needs {0}"),
      loss(Code::kKimeraFrameRateRounded, "frame-rate-rounded", "{0} {2} Hz",
           "Kimera-VIO reads rate_hz as an int: {3} is written", "nothing to do: the rate only paces the images"),
      clause(Code::kKimeraOneOffset, "Kimera-VIO has one for all cameras"),
      clause(Code::kKimeraNoImuFile, "imu_time_shift is in ImuParams.yaml, which is not written"),

      // Written: values that the input does not state.
      clause(Code::kKimeraInitialValue, "{0} (of Kimera-VIO's params/Euroc: it stops without one)"),
      clause(Code::kKimeraStockTuning, "as in Kimera-VIO's params/Euroc"),

      clause(Code::kKimeraFirstIsLeft, "Kimera-VIO's left camera is the first one"),
      clause(Code::kEurocWrote, "a sensor.yaml for each sensor, as EuRoC has them"),
      clause(Code::kEurocWroteImu, "an IMU's sensor.yaml, as EuRoC has it"),
      clause(Code::kCuvslamRigFound, "the key {0} of cuVSLAM's examples"),
      clause(Code::kCuvslamRigHeadline, "a rig for cuVSLAM's examples"),
      warning(Code::kCuvslamNoDistortion, "program-ignores", "{0} {1} is not read: cuVSLAM's example undistorts nothing"),
      clause(Code::kKimeraWrote, "CameraParams and ImuParams for Kimera-VIO"),
      clause(Code::kKimeraWrotePair, "{0}; {1} is left and {2} right{3}"),
      clause(Code::kKimeraWroteOne, "{0}, monocular with {1} (it shares less than a quarter of its image with {2}){3}"),
      clause(Code::kKimeraOpensNone, "; it opens no file of {0:and}"),
      clause(Code::kKimeraWroteImu, "an ImuParams.yaml for Kimera-VIO"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
