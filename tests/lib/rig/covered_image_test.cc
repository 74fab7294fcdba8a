// SPDX-License-Identifier: BSD-3-Clause
// Images whose corners prove that every pixel has a ray, against pixels all over them.
#include "../convert/random_model.h"

#include <fca/rig/covered_image.h>
#include <fca/rig/rotation.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace fca::test {
namespace {

RC_GTEST_PROP(CoveredImage, HasARayAtEachPixelNoFurtherOutThanACorner, ()) {
  const CameraModel model = random_model(*rc::gen::inRange<std::size_t>(0, 11));
  const ImageSize size = {*rc::gen::inRange(1, 2000), *rc::gen::inRange(1, 2000)};
  if (!is_surely_covered(model, size)) return;
  const double right = size.width - 1.0;
  const double bottom = size.height - 1.0;
  double furthest = 0.0;
  for (const Pixel& corner : {Pixel{0.0, 0.0}, Pixel{right, 0.0}, Pixel{0.0, bottom}, Pixel{right, bottom}})
    furthest = std::max(furthest, angle_from_axis(*unproject(model, corner)));
  constexpr int kSteps = 20;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const std::optional<Ray> ray = unproject(model, {right * i / kSteps, bottom * j / kSteps});
      RC_ASSERT(ray.has_value());
      RC_ASSERT(angle_from_axis(*ray) <= furthest + 1e-9);
    }
  }
}

TEST(CoveredImage, IsNotSureOfALensThatEndsInside) {
  const CameraModel ends = Intrinsics<Ds>{{300.0, 300.0, 199.5, 149.5, 0.9, 0.0}};  // 335 px from its centre
  EXPECT_TRUE(is_surely_covered(ends, {400, 300}));
  EXPECT_FALSE(is_surely_covered(ends, {4000, 3000}));
}

}  // namespace
}  // namespace fca::test
