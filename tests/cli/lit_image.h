// SPDX-License-Identifier: BSD-3-Clause
// Images whose light lies in a known circle, and the lens that might have taken them.
#pragma once

#include <cmath>
#include <string>

namespace fca::test {

/// A wide lens whose axis hits the middle of its image, as a camera of a camchain.
inline const std::string kLens = R"(  camera_model: pinhole
  intrinsics: [190.0, 190.0, 255.5, 255.5]
  distortion_model: equidistant
  distortion_coeffs: [0.003, 0.001, -0.002, 0.0002]
  resolution: [512, 512]
)";
/// It alone.
inline const std::string kChain = "cam0:\n" + kLens;

/// A grey image whose light lies in a circle.
struct Lit {
  int width = 512;
  int height = 512;
  double u = 255.5;  ///< The circle's centre,
  double v = 255.5;
  double radius = 240.0;
  double lit = 7.0;       ///< of which only the sector up to there [rad] is bright.
  double flatness = 1.0;  ///< Less than 1: an ellipse.
  int grey = 1;           ///< What a grey level is, in samples of 16 bits; 1: of 8 bits.

  [[nodiscard]] bool contains(double at_u, double at_v) const { return std::hypot(at_u - u, (at_v - v) / flatness) <= radius; }

  /// As PGM.
  [[nodiscard]] std::string file() const {
    std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + (grey > 1 ? "\n65535\n" : "\n255\n");
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const bool bright = std::atan2(row - v, column - u) + 3.2 <= lit;
        const int level = contains(column, row) ? (bright ? 120 + (column / 9 + row / 5) % 40 : 6) : 5 + (column * row) % 2;
        if (grey > 1) bytes += static_cast<char>(level * grey / 256);
        bytes += static_cast<char>(level * grey % 256);
      }
    }
    return bytes;
  }

  [[nodiscard]] double share_beyond() const {
    int beyond = 0;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) beyond += contains(column, row) ? 0 : 1;
    }
    return static_cast<double>(beyond) / (static_cast<double>(width) * height);
  }
};

}  // namespace fca::test
