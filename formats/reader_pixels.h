// SPDX-License-Identifier: BSD-3-Clause
// Private: pixels of a file beside those of a program that reads it and may scale its images.
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <fca/models/camera_model.h>

#include <cmath>
#include <optional>

namespace fca {

/// Between pixels. (std::hypot, which also knows distances that doubles hold and their squares do not, takes ten times as
/// long.)
[[nodiscard]] inline double distance(const Pixel& a, const Pixel& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}

[[nodiscard]] inline Pixel in_file_pixels(const Pixel& pixel, const consumers::ConsumerCamera& theirs) {
  return {pixel[0] / theirs.scale[0], pixel[1] / theirs.scale[1]};
}

[[nodiscard]] inline Pixel in_their_pixels(const Pixel& pixel, const consumers::ConsumerCamera& theirs) {
  return {pixel[0] * theirs.scale[0], pixel[1] * theirs.scale[1]};
}

/// How far the program's ray of the pixel lies from it, by the program's own formula; 0 where it has none. Both are the
/// program's, so that nothing else is counted: its inverse goes wrong beyond 90 degrees.
[[nodiscard]] inline double wrong_ray_px(const Pixel& pixel, const consumers::ConsumerCamera& theirs) {
  if (!theirs.unproject) return 0.0;
  const std::optional<Ray> ray = theirs.unproject(in_their_pixels(pixel, theirs));
  const std::optional<Pixel> back = ray ? theirs.project(*ray) : std::nullopt;
  return back ? distance(in_file_pixels(*back, theirs), pixel) : 0.0;
}

}  // namespace fca
