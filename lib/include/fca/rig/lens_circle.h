// SPDX-License-Identifier: BSD-3-Clause
// The part of an image that is lens: fisheye lenses leave the corners of the sensor dark.
#pragma once

#include <fca/message.h>
#include <fca/models/camera_model.h>

namespace fca {

/// A circle in an image, in its pixels.
struct LensCircle {
  Pixel centre{};
  double radius_px = 0.0;
  double rim_share = 0.0;  ///< Of the rim inside the image: how much of it was seen, 0 to 1.
  double rms_px = 0.0;     ///< Of what was seen of the rim, from the circle.
  Message why = {};        ///< What shows it, a clause: "the image circle of a.png".
  /// Of the light that falls within a tenth of the radius about the rim, what falls at the rim itself: near 1 at a lens's edge,
  /// near 0 where a glow or a vignette ends somewhere.
  double sharpness = 0.0;
  bool operator==(const LensCircle&) const = default;

  /// How far outside the circle, in px; negative inside.
  [[nodiscard]] double beyond(const Pixel& pixel) const;
  [[nodiscard]] bool contains(const Pixel& pixel) const { return beyond(pixel) <= 0.0; }
  /// Of the rim, `azimuth` [rad] from u towards v.
  [[nodiscard]] Pixel rim(double azimuth) const;
};

}  // namespace fca
