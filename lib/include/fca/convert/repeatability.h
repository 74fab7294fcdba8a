// SPDX-License-Identifier: BSD-3-Clause
// By how much two independent calibrations of one camera differ: what a conversion's error is to be compared with where nothing
// specifies the calibration's own uncertainty.
#pragma once

#include <string_view>

namespace fca {

struct Repeatability {
  std::string_view camera;  ///< Which, with its image.
  std::string_view source;  ///< Who calibrated it.
  double rms_px = 0.0;      ///< Over the image, in its pixels.
};

inline constexpr Repeatability kWideRepeatability = {"TUM-VI's cam0 (512 x 512 px, 195 deg)", "Kalibr's kb4 and Basalt's ds",
                                                     0.438};
inline constexpr Repeatability kNarrowRepeatability = {"EuRoC's cam0 (752 x 480 px)", "Kalibr's radtan and Basalt's ds", 2.26};

/// Of a camera whose lens is like one that sees `max_angle_deg` from its axis.
[[nodiscard]] constexpr const Repeatability& typical_repeatability(double max_angle_deg) {
  constexpr double kWideDeg = 60.0;
  return max_angle_deg > kWideDeg ? kWideRepeatability : kNarrowRepeatability;
}

}  // namespace fca
