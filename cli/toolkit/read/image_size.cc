// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/toolkit/image.h>

#include <cmath>

namespace fca {

bool has_size_of(const Camera& camera, bool changed, const Image& image, const std::string& path, Diagnostics& diagnostics) {
  const ImageSize& known = *camera.image_size;
  const ImageSize is = {image.width, image.height};
  if (is == known) return true;
  // Some pixels may be cut off on each side before scaling: the proportions need only agree to a pixel.
  const bool scaled = std::abs(1.0 * known.width * is.height / known.height - is.width) <= 1.0;
  const bool part = is.width <= known.width && is.height <= known.height;
  Message fix = {Code::kGiveCalibratedSize};
  if (changed) {
    fix = {Code::kSayWhatWasDone};
  } else if (scaled) {
    fix = {Code::kIfScaled, {is.width, is.height}};
  } else if (part) {
    fix = {Code::kIfPart, {is.width, is.height}};
  }
  diagnostics.add(Code::kImageOfOtherSize, {is.width, is.height, camera.name, known.width, known.height, fix}, {path, 0, 0});
  return false;
}

}  // namespace fca
