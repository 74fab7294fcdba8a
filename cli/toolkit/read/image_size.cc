// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include <fca/toolkit/image.h>

#include <cmath>

namespace fca {

bool has_size_of(const Camera& camera, bool changed, const Image& image, const std::string& path, Diagnostics& diagnostics) {
  const ImageSize& known = *camera.image_size;
  const ImageSize is = {image.width, image.height};
  if (is == known) return true;
  // Of a camera's pixels some may be left out on each side before they are scaled: the same proportions to a pixel.
  const bool scaled = std::abs(1.0 * known.width * is.height / known.height - is.width) <= 1.0;
  const bool part = is.width <= known.width && is.height <= known.height;
  const std::string size = std::to_string(is.width) + "x" + std::to_string(is.height);
  std::string fix = "give the images of the calibrated size";
  if (changed) {
    fix = "--crop, --binning and --resize say what was done to the images that are given; leave out what was not";
  } else if (scaled) {
    fix = "if it is the calibrated image, scaled: --resize " + size;
  } else if (part) {
    fix = "if it is a part of the calibrated image: --crop X,Y," + std::to_string(is.width) + "," + std::to_string(is.height);
  }
  diagnostics.error(
      "image-size",
      "the image is " + size_in_words(is) + " px, and " + camera.name + " is known for " + size_in_words(known) + " px",
      {path, 0, 0}, fix);
  return false;
}

}  // namespace fca
