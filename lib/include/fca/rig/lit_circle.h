// SPDX-License-Identifier: BSD-3-Clause
// Where light falls on a sensor: the circle that a fisheye lens illuminates, found in images of any scene.
#pragma once

#include <fca/rig/grey_image.h>
#include <fca/rig/lens_circle.h>

#include <optional>
#include <span>

namespace fca {

/// Each pixel's brightest: what is dark in one scene another one lights. All of one size, at least one.
[[nodiscard]] GreyImage brightest(std::span<const GreyImage> images);

/// The circle outside of which the image is dark. Robust to rims that lie in the dark for the most part and to flare beyond
/// them: from the borders inwards each of 720 directions has its steps from dark to light; of all circles through three of them
/// the one of whose rim the longest piece is seen is refined by least squares of distances. Nothing where no dark border is
/// seen (the lens lights the whole sensor, or the scene lights nothing): less than 12 % of the rim inside the image is seen, or
/// what lies beyond the circle is not dark. `why` is left empty.
[[nodiscard]] std::optional<LensCircle> find_lit_circle(const GreyImage& image);

}  // namespace fca
