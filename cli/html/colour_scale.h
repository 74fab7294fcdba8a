// SPDX-License-Identifier: BSD-3-Clause
// Viridis, a colour scale in which equal steps look equal, to people who see fewer colours, too, and in grey print. Its anchors
// are those that its authors published (N. Smith and S. van der Walt for matplotlib 2.0, CC0), eleven of the 256, with straight
// lines between them: an SVG gradient of the same stops has the same colours.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace fca::cli {

using Rgb = std::array<std::uint8_t, 3>;

inline constexpr std::array<Rgb, 11> kViridis = {{{0x44, 0x01, 0x54},
                                                  {0x48, 0x25, 0x76},
                                                  {0x41, 0x44, 0x87},
                                                  {0x35, 0x60, 0x8D},
                                                  {0x2A, 0x78, 0x8E},
                                                  {0x21, 0x90, 0x8C},
                                                  {0x22, 0xA8, 0x84},
                                                  {0x43, 0xBF, 0x71},
                                                  {0x7A, 0xD1, 0x51},
                                                  {0xBB, 0xDF, 0x27},
                                                  {0xFD, 0xE7, 0x25}}};

/// The colour at a share in [0, 1] of the scale; what lies beyond has that of the end.
[[nodiscard]] Rgb viridis(double share);
/// "#440154"
[[nodiscard]] std::string css_colour(const Rgb& colour);

}  // namespace fca::cli
