// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fca {

/// An image with the samples that its file has: 1 (grey), 3 (blue, green, red) or 4 channels (and opacity); rows from the top,
/// without gaps.
struct Image {
  enum class Sample : std::uint8_t { k8Bit, k16Bit, kFloat };
  int width = 0;
  int height = 0;
  int channels = 1;
  Sample sample = Sample::k8Bit;
  std::vector<std::uint8_t> bytes;
};

/// Larger ones are not read: a few hundred bytes of PNG can be gigabytes of black.
inline constexpr std::int64_t kMostPixels = 1LL << 27U;

/// An error, with how to fix it, unless the image is of the size for which the camera is known. `changed`: that is not the
/// calibrated one (cropped, binned or resized).
[[nodiscard]] bool has_size_of(const Camera& camera, bool changed, const Image& image, const std::string& path,
                               Diagnostics& diagnostics);

enum class Interpolation : std::uint8_t { kBilinear, kLanczos };

}  // namespace fca
