// SPDX-License-Identifier: BSD-3-Clause
// A field over an image as a picture: colours, contours, what was not scored, and the pixel to look at.
#pragma once

#include "html.h"

#include <fca/rig/lens_circle.h>
#include <fca/toolkit/image_field.h>

#include <optional>
#include <string>

namespace fca::cli {

/// Of a colour bar.
struct ColourScale {
  double from = 0.0;
  double to = 1.0;
  bool logarithmic = false;
  std::string unit;  ///< "px"
};

/// An error [px] below which there is rounding, and nothing to be seen.
inline constexpr double kSeenError = 1e-6;
/// And one that no scale need go beyond.
inline constexpr double kLargestError = 1e9;

/// A scale of errors up to `largest` [px], which need not be a round number: three decades.
[[nodiscard]] ColourScale error_scale(double largest);
/// A scale of angles that the field has.
[[nodiscard]] ColourScale angle_scale(const ImageField& field);

struct MapFigure {
  std::string title;
  std::string what;   ///< For who cannot see it.
  ImageField field;   ///< What is coloured.
  ImageField coarse;  ///< The same with fewer cells, for contours.
  ColourScale scale;
  std::optional<Pixel> marked;         ///< The worst pixel,
  std::string mark_label;              ///< and what it is: "max 2.96 px".
  Pixel axis{};                        ///< The principal point.
  std::optional<LensCircle> rim = {};  ///< Of the lens, as images show it.
};

/// The colours of all colour bars of a page: once, before the first map.
void put_colour_scale(Html& html);

/// A figure with its colour bar and legend.
void put_map(Html& html, const MapFigure& figure);

}  // namespace fca::cli
