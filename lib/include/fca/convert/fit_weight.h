// SPDX-License-Identifier: BSD-3-Clause
// What counts how much in the sum of squares that a fit makes small.
#pragma once

#include <fca/rig/grey_image.h>

#include <cstdint>
#include <memory>

namespace fca {

enum class WeightKind : std::uint8_t {
  kPixel,  ///< Each pixel counts alike.
  kAngle,  ///< Each pixel counts by the solid angle that it sees: each direction alike.
  kImage,  ///< Each pixel counts by an image's grey there.
};

struct FitWeight {
  WeightKind kind = WeightKind::kPixel;
  /// Of kImage: as large as the camera's image, samples >= 0, any unit. Between pixels it is interpolated. Black counts a
  /// billionth of the brightest: only to decide what nothing else does.
  std::shared_ptr<const GreyImage> density = nullptr;
  bool operator==(const FitWeight&) const = default;
};

}  // namespace fca
