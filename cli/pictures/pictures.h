// SPDX-License-Identifier: BSD-3-Clause
// What needs OpenCV's image modules. Loading those takes longer than a conversion, so that they are in a module of their own,
// which is loaded when a picture is asked for; these functions are its door.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fca::cli {

/// Rows from the top, four bytes per pixel: red, green, blue, opacity.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// The bytes of a PNG file. Throws consumers::MissingModule where the installation lacks the module.
[[nodiscard]] std::string png(const Picture& picture);

}  // namespace fca::cli
