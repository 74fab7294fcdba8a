// SPDX-License-Identifier: BSD-3-Clause
// What readers and writers of the configurations of stella_vslam and FAST-LIVO say, and what these programs do.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> slam_codes() {
  static constexpr std::array kRows = {
      // Read. {0}: the program, {1}: the word in the file, {2}: why.
      error(Code::kSlamModelNotRead, "unknown-model", "fca-io does not read cameras of {0}'s model {1}: {2}"),
      clause(Code::kSlamNotAllPowers, "it has no model with all powers of the angle"),
      clause(Code::kSlamInCalibResults, "their numbers are in the file that cam_calib_file names, which fca-io reads"),

      // Written.
      clause(Code::kSlamFirstIsLeft, "{0} takes the first camera of a stereo pair for the left one"),
      clause(Code::kStellaLacksLens, "lenses that StereoRectifier takes (perspective or fisheye, both alike)"),
      clause(Code::kFastLivoNoK3, "FAST-LIVO's Pinhole has no k3"),

      // The programs.
      named_misreading(Code::kFastLivoSaysNoDistortion,
                       "{0} is {1}: FAST-LIVO takes a lens whose first coefficient is within 1e-7 of 0 for one without "
                       "distortion, and reads no further coefficient"),
      clause(Code::kSlamRaysInSteps, "from pixel to ray it takes {0} steps of a fixed-point iteration"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
