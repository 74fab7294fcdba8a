// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fca {

/// An image with the sample type of its file. It has 1 channel (grey), 3 channels (blue, green, red) or 4 channels (blue,
/// green, red, opacity). `bytes` contains the rows from the top, without gaps, with the channels of a pixel next to each other.
struct Image {
  enum class Sample : std::uint8_t { k8Bit, k16Bit, kFloat };
  int width = 0;
  int height = 0;
  int channels = 1;
  Sample sample = Sample::k8Bit;
  std::vector<std::uint8_t> bytes;
};

/// The largest number of pixels of an image that is read. A black PNG of a few hundred bytes can have gigabytes of pixels.
inline constexpr std::int64_t kMostPixels = 1LL << 27U;

/// True if the image has the camera's image size, which must be known. If not, adds an error with a remedy. `changed`: the
/// camera is already that of changed images (cropped, binned or resized); this decides the remedy.
[[nodiscard]] bool has_size_of(const Camera& camera, bool changed, const Image& image, const std::string& path,
                               Diagnostics& diagnostics);

enum class Interpolation : std::uint8_t { kBilinear, kLanczos };

}  // namespace fca
