// SPDX-License-Identifier: BSD-3-Clause
// What Kimera-VIO and cuVSLAM's EuRoC example report about a file. {0} is the key, where the sentence begins with one.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> sensor_program_codes() {
  static constexpr std::array kRows = {
      named_refusal(Code::kKimeraSaysFewCoefficients, "{0} has {1} numbers; Kimera-VIO wants four or more and stops",
                    "for a camera without distortion, write zeros"),
      named_refusal(Code::kKimeraSaysFourCoefficients,
                    "{0} has {1} numbers; OpenCV's fisheye takes four, and Kimera-VIO stops"),
      named_refusal(Code::kKimeraSaysUnknownModel, "{0} is {1}, neither pinhole nor omni; Kimera-VIO stops"),
      named_refusal(Code::kKimeraSaysUnknownDistortion,
                    "{0} is {1}; Kimera-VIO knows none, radial-tangential (radtan, plumb_bob) and equidistant, and stops"),
      named_misreading(Code::kKimeraSaysNoOmni, "{0} is omni: fca-io does not know how Kimera-VIO computes such a camera"),
      named_refusal(Code::kKimeraSaysRateZero, "{0} is {1}, which Kimera-VIO reads as the int {2}, and stops"),
      named_misreading(Code::kKimeraSaysRateRounded, "{0} is {1}, which Kimera-VIO reads as the int {2}",
                       "write a whole number"),
      named_misreading(Code::kKimeraSaysFirstFour,
                       "{0}: Kimera-VIO undistorts with all {1} coefficients, and projects with the first four"),
      named_refusal(Code::kKimeraSaysNoIdentity,
                    "{0} is not the identity: Kimera-VIO's body frame must be the IMU's, or it stops"),

      named_refusal(Code::kCuvslamSaysNoPose, "no key begins with T_; cuVSLAM's EuRoC example stops", kAddTheKey),
      named_misreading(Code::kCuvslamSaysTakenForBrown,
                       "{0} is {1}: cuVSLAM's EuRoC example reads that only from a sensor_recalibrated.yaml; in a sensor.yaml "
                       "it takes the coefficients for k1 k2 p1 p2",
                       "for cuVSLAM, rename the file sensor_recalibrated.yaml"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
