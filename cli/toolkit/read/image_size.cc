// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/toolkit/image.h>

#include <cmath>

namespace fca {

bool has_size_of(const Camera& camera, bool changed, const Image& image, const std::string& path, Diagnostics& diagnostics) {
  const ImageSize& expected = *camera.image_size;
  const ImageSize actual = {image.width, image.height};
  if (actual == expected) return true;
  // The image may have lost some pixels at its borders before it was scaled. So the proportions need only agree to one pixel.
  const bool may_be_scaled = std::abs(1.0 * expected.width * actual.height / expected.height - actual.width) <= 1.0;
  const bool may_be_part = actual.width <= expected.width && actual.height <= expected.height;
  Message fix = {Code::kGiveCalibratedSize};
  if (changed) {
    fix = {Code::kSayWhatWasDone};
  } else if (may_be_scaled) {
    fix = {Code::kIfScaled, {actual.width, actual.height}};
  } else if (may_be_part) {
    fix = {Code::kIfPart, {actual.width, actual.height}};
  }
  diagnostics.add(Code::kImageOfOtherSize, {actual.width, actual.height, camera.name, expected.width, expected.height, fix},
                  {path, 0, 0});
  return false;
}

}  // namespace fca
