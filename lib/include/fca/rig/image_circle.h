// SPDX-License-Identifier: BSD-3-Clause
// Where light falls on a sensor: the circle that a fisheye lens illuminates, found in images of any scene.
#pragma once

#include <fca/rig/grey_image.h>
#include <fca/rig/lens_circle.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fca {

/// Each pixel's brightest: what is dark in one scene another one lights. All of one size, at least one.
[[nodiscard]] GreyImage brightest(std::span<const GreyImage> images);

/// The circle outside of which the image is dark, its centre within half its radius of the principal point (a lamp is a lit
/// circle, too). Robust to noise, to rims that lie in the dark for the most part, and to flare and glow beyond them: from the
/// borders inwards each of 720 directions has its steps from dark to light; of all circles through three of them the one of
/// whose rim the longest piece is seen is refined by least squares of distances. If what is found is not sharp, brighter levels
/// of what counts as dark are tried. Nothing where no dark border is seen (the lens lights the whole sensor, or the scene
/// lights nothing): less than 12 % of the rim inside the image is seen (30 % with brighter levels), or what lies beyond is not
/// dark. `why` stays empty.
[[nodiscard]] std::optional<LensCircle> find_image_circle(const GreyImage& image, const Pixel& principal_point);

/// Images of one camera, one after the other: what each shows alone, and what they show together. One that shows nothing, or
/// a glow, does no harm to the others.
class ImageCircleSearch {
 public:
  explicit ImageCircleSearch(const Pixel& principal_point) : principal_point_(principal_point) {}

  /// Of the size of those before.
  void add(const GreyImage& image);
  /// The circle that most images show; where no two agree, of all together, or of the one that shows more of a rim, or a
  /// sharper one.
  [[nodiscard]] std::optional<LensCircle> best() const;
  /// What an image shows alone, counted from 0 in the order of add().
  [[nodiscard]] const std::optional<LensCircle>& alone(std::size_t image) const { return alone_.at(image); }
  /// The images that alone show this circle. None: only together they do.
  [[nodiscard]] std::vector<std::size_t> showing(const LensCircle& circle) const;
  /// The images that alone show a good part of the rim of another circle.
  [[nodiscard]] std::vector<std::size_t> contradicting(const LensCircle& circle) const;

 private:
  Pixel principal_point_;
  std::optional<GreyImage> together_;
  std::vector<std::optional<LensCircle>> alone_;
};

}  // namespace fca
