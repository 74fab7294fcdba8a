// SPDX-License-Identifier: BSD-3-Clause
#include "compute_map.h"

#include "parallel_for.h"

#include <fca/code.h>
#include <fca/toolkit/image.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace fca {

bool fits_cv_remap(const Camera& camera, Diagnostics& diagnostics) {
  if (!camera.image_size) {
    diagnostics.add(Code::kCameraWithoutSize, {camera.name});
    return false;
  }
  const auto& [width, height] = *camera.image_size;
  if (std::max(width, height) <= kLongestSidePx && std::int64_t{width} * height <= kMostPixels) return true;
  diagnostics.add(Code::kImagesTooLarge, {width, height, kLongestSidePx});
  return false;
}

ImageMap compute_map(const ImageMapper& mapper, std::size_t jobs) {
  const ImageSize size = mapper.size();
  const auto stride = 2 * static_cast<std::size_t>(size.width);
  const auto rows = static_cast<std::size_t>(size.height);
  ImageMap map{size, std::vector<float>(stride * rows)};
  constexpr std::size_t kRowsPerBand = 16;
  parallel_for((rows + kRowsPerBand - 1) / kRowsPerBand, jobs, [&](std::size_t band) {
    for (std::size_t row = band * kRowsPerBand; row < std::min(rows, (band + 1) * kRowsPerBand); ++row)
      mapper.row(static_cast<int>(row), std::span(map.uv).subspan(row * stride, stride));
  });
  return map;
}

}  // namespace fca
