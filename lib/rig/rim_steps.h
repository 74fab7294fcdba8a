// SPDX-License-Identifier: BSD-3-Clause
// Where an image turns from dark to light on the way in from its borders.
#pragma once

#include <fca/models/camera_model.h>
#include <fca/rig/grey_image.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace fca::internal {

inline constexpr int kDirections = 720;

/// What parts dark from light in an image.
struct Levels {
  float black = 0.0F;      ///< of its darkest corner
  float bright = 0.0F;     ///< all but a small share of the image are darker
  float threshold = 0.0F;  ///< what is brighter counts as lit
};

/// Samples of an image, between pixels, too.
class GreyView {
 public:
  explicit GreyView(const GreyImage& image) : image_(image) {}

  [[nodiscard]] const GreyImage& image() const { return image_; }
  [[nodiscard]] float at(int column, int row) const {
    return image_
        .samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(column)];
  }
  [[nodiscard]] bool inside(const Pixel& pixel) const {
    return pixel[0] >= 0.0 && pixel[1] >= 0.0 && pixel[0] <= image_.width - 1.0 && pixel[1] <= image_.height - 1.0;
  }
  /// Between pixels, too; `pixel` is inside.
  [[nodiscard]] double value(const Pixel& pixel) const {
    const int column = std::min(static_cast<int>(pixel[0]), image_.width - 2);
    const int row = std::min(static_cast<int>(pixel[1]), image_.height - 2);
    const double s = pixel[0] - column;
    const double t = pixel[1] - row;
    return (1.0 - t) * ((1.0 - s) * at(column, row) + s * at(column + 1, row)) +
           t * ((1.0 - s) * at(column, row + 1) + s * at(column + 1, row + 1));
  }

 private:
  const GreyImage& image_;
};

/// The image without much of its noise: means of 5 x 5 pixels (of small images 3 x 3).
[[nodiscard]] GreyImage smoothed(const GreyImage& image);

/// From the darkest corner, whose noise is what dark is here, and from what is bright: `bright_share` of the image. The
/// threshold is the lowest that noise does not pass. Nothing if nothing is lit.
[[nodiscard]] std::optional<Levels> levels_of(const GreyView& view, double bright_share);

/// A direction's steps from dark to light, from the border inwards.
using Steps = std::vector<Pixel>;

/// Of each direction from the centre. Light that begins at the image's border says nothing of a rim.
[[nodiscard]] std::vector<Steps> steps_from_dark(const GreyView& view, const Levels& levels, const Pixel& centre);

}  // namespace fca::internal
