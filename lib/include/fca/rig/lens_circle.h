// SPDX-License-Identifier: BSD-3-Clause
// The part of an image that is lens: fisheye lenses leave the corners of the sensor dark.
#pragma once

#include <fca/models/camera_model.h>

#include <string>

namespace fca {

/// A circle in an image, in its pixels.
struct LensCircle {
  Pixel centre{};
  double radius_px = 0.0;
  double rim_share = 0.0;  ///< Of the rim inside the image: how much of it was seen, 0 to 1.
  double rms_px = 0.0;     ///< Of what was seen of the rim, from the circle.
  std::string why;         ///< What shows it, for people: "the lit circle of a.png".
  bool operator==(const LensCircle&) const = default;

  [[nodiscard]] bool contains(const Pixel& pixel) const;
};

}  // namespace fca
