// SPDX-License-Identifier: BSD-3-Clause
// Many pixels at once have the rays that each has alone, to 1e-12, and the same pixels have none.
#include "../convert/random_model.h"

#include <fca/models/camera_model.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace fca {
namespace {

/// Pixels of an image of 640 x 480 and of a margin around it, row by row, as u v u v ...
std::vector<double> grid(double margin_px) {
  constexpr int kColumns = 48;
  constexpr int kRows = 32;
  std::vector<double> pixels;
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      pixels.push_back(-margin_px + (639.0 + 2.0 * margin_px) * i / (kColumns - 1));
      pixels.push_back(-margin_px + (479.0 + 2.0 * margin_px) * j / (kRows - 1));
    }
  }
  return pixels;
}

/// Whether unproject_all() says of each pixel what unproject() does.
bool says_the_same(const CameraModel& model, const std::vector<double>& pixels) {
  constexpr double kRelative = 1e-12;
  std::vector<double> rays(pixels.size() / 2 * 3);
  unproject_all(model, pixels, rays);
  bool same = true;
  for (std::size_t i = 0; i < pixels.size() / 2; ++i) {
    const double* found = &rays[3 * i];
    const std::optional<Ray> ray = unproject(model, {pixels[2 * i], pixels[2 * i + 1]});
    if (!ray) {
      same = same && std::isnan(found[0]) && std::isnan(found[1]) && std::isnan(found[2]);
      continue;
    }
    for (std::size_t axis = 0; axis < ray->size(); ++axis) same = same && std::abs(found[axis] - (*ray)[axis]) <= kRelative;
  }
  return same;
}

RC_GTEST_PROP(UnprojectAll, SaysOfManyPixelsWhatItSaysOfEach, ()) {
  const CameraModel model = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  RC_ASSERT(says_the_same(model, grid(*rc::gen::element(-200.0, 0.0, 100.0, 1e6))));
}

RC_GTEST_PROP(UnprojectAll, APixelThatIsNoNumberHasNoRayAndHarmsNoOther, ()) {
  const CameraModel model = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  std::vector<double> pixels = grid(0.0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity, 1e308, -1e200, 1e20})
    pixels[*rc::gen::inRange<std::size_t>(0, pixels.size())] = odd;
  RC_ASSERT(says_the_same(model, pixels));
}

}  // namespace
}  // namespace fca
