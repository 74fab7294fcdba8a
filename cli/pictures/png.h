// SPDX-License-Identifier: BSD-3-Clause
// Drawn pictures of few colours as PNG files. Made here with zlib: OpenCV's image modules take longer to load than a page
// takes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fca::cli {

/// Red, green, blue, opacity (255: opaque).
using Rgba = std::array<std::uint8_t, 4>;

/// A picture of at most 256 colours.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<Rgba> palette;
  std::vector<std::uint8_t> colours;  ///< Each pixel's place in the palette, row by row from the top.
};

/// The bytes of a PNG file (ISO/IEC 15948), colour type 3.
[[nodiscard]] std::string png(const Picture& picture);

}  // namespace fca::cli
