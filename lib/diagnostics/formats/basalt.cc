// SPDX-License-Identifier: BSD-3-Clause
// Basalt's calibrations, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> basalt_codes() {
  static constexpr std::array kRows = {
      error(Code::kBasaltOffsetInvalid, "out-of-range", "{0}: {1}", "write it in nanoseconds: t_imu = t_cam + offset"),
      clause(Code::kBasaltFound, "value0 with {0}"),

      // Read.
      error(Code::kBasaltWrongSyntax, "wrong-syntax", "a Basalt calibration is one JSON object"),
      error(Code::kBasaltNoObject, "not-a-mapping", "{0} is not an object of keys and values"),
      error(Code::kBasaltNoCameraList, "not-a-list", "{0} is not a list of cameras"),
      reader_warning(Code::kBasaltMissingKeys, "missing-key", "value0 has no {0:or}: Basalt stops"),
      error(Code::kBasaltItemCount, "wrong-length", "{0} has {1} items; it must have one for each camera of intrinsics ({2})"),
      error(Code::kBasaltNoList, "not-a-list", "{0} is not a list; it must have one item for each camera of intrinsics ({1})"),
      error(Code::kBasaltUnknownModel, "unknown-model",
            "{0} camera_type '{1}' is not one of ds, eucm, ucm, kb4, fov, pinhole and pinhole-radtan8"),
      warning(Code::kBasaltUnknownParameter, "program-ignores", "{0} {1} is not a parameter of {2} and is not read"),
      error(Code::kBasaltNoSize, "wrong-length", "{0} resolution is not a list of width and height"),
      error(Code::kBasaltNoPose, "not-a-mapping", "{0} is not an object of px py pz qx qy qz qw"),
      error(Code::kBasaltQuaternionLength, "not-a-rotation",
            "{0}: the quaternion has length {1:.4}, not 1, and Basalt does not normalise it",
            "divide qx, qy, qz and qw by that length"),
      error(Code::kBasaltQuaternionZero, "not-a-rotation",
            "{0}: the quaternion has length {1:.4}, not 1, and Basalt does not normalise it"),
      error(Code::kBasaltOffsetNotWhole, "not-an-integer", "{0} is '{1}'; it must be a whole number",
            "write it in nanoseconds"),

      // Written: what stands against it.
      error(Code::kBasaltMirror, "not-a-rotation",
            "{0}: its pose in {1} is a mirror image, which a quaternion of T_imu_cam cannot hold"),
      clause(Code::kBasaltDemandsSize, "Basalt needs a resolution"),

      // Written: losses and their reasons.
      clause(Code::kBasaltNoPlace, "a Basalt calibration has no place for it"),
      clause(Code::kBasaltOneOffset, "Basalt has one for all cameras"),
      clause(Code::kBasaltNoRadiusLimit, "{0}'s model has no such limit"),
      loss(Code::kBasaltOffsetRounded, "time-offset-rounded", "the time offset {2:.12} s", "Basalt counts whole nanoseconds",
           "nothing to do: no camera's clock is that precise"),
      loss(Code::kBasaltPoseRecomputed, "pose-recomputed", "pose of {0} in {2}",
           "its matrix is a rotation only to {3:.2}, and Basalt's quaternion holds the nearest rotation",
           "nothing to do: the nearest rotation is the right one"),
      loss(Code::kBasaltStaleRadius, "stale-derived", "{0} {1}", "it stays unchanged next to a new lens",
           "write where the new lens ends, or -1 for no limit"),
      loss(Code::kBasaltImuDropped, "imu-dropped", "{0} noise and rate", "Basalt has one IMU",
           "keep its file; a complete IMU can be written to one of Kalibr's"),

      // Written: values that the input does not state.
      clause(Code::kBasaltInitialValue, "{0} (Basalt's own initial value: it stops without one)"),
      clause(Code::kBasaltIdentity, "identity: its pose in the IMU is not in the input, and Basalt stops without it"),
      clause(Code::kBasaltPoseInFrame, "the pose in {0}: its pose in the IMU is not in the input, and Basalt stops without it"),

      clause(Code::kBasaltWrote, "a calibration for Basalt"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
