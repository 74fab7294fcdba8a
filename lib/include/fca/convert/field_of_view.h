// SPDX-License-Identifier: BSD-3-Clause
// The valid field of view of a camera: the part of its image that is lens, where a conversion counts.
#pragma once

#include <fca/convert/lens.h>
#include <fca/diagnostics.h>
#include <fca/message.h>
#include <fca/models/camera_model.h>
#include <fca/rig/rig.h>

#include <optional>
#include <string>

namespace fca {

/// The pixels of [0, width - 1] x [0, height - 1] whose ray lies within max_angle of the axis and that lie in the circle, if
/// there is one.
struct FieldOfView {
  ImageSize size;
  double max_angle_rad = 0.0;             ///< From the axis; the largest angle in the field of view.
  Message why = {};                       ///< What decided where it ends, a clause.
  std::optional<LensCircle> circle = {};  ///< Only if it cuts a corner off the image.

  /// Does light fall there? Everywhere without a circle.
  [[nodiscard]] bool is_lit(const Pixel& pixel) const { return !circle || circle->contains(pixel); }
  /// The source's ray of a pixel of the field of view; nothing outside.
  [[nodiscard]] std::optional<Ray> ray(const Lens& source, const Pixel& pixel) const;
};

/// The field of view of a camera: the whole image, cut where the model itself ends, at `limit_rad` from the axis if one is
/// given, and where the camera's lens circle ends. An error (and nothing) where the camera has no usable size or parameters, or
/// no pixel of the image has a ray.
[[nodiscard]] std::optional<FieldOfView> field_of_view_of(const Camera& camera, std::optional<double> limit_rad,
                                                          Diagnostics& diagnostics);

/// The same of any lens in front of an image of that size; `name` is for diagnostics.
[[nodiscard]] std::optional<FieldOfView> field_of_view_of(const Lens& lens, const ImageSize& size,
                                                          std::optional<double> limit_rad, const std::string& name,
                                                          Diagnostics& diagnostics);

}  // namespace fca
