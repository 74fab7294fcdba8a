// SPDX-License-Identifier: BSD-3-Clause
// Where a line crosses the pixels of an angle from the axis: found in closed form, and as the model itself says.
#include "convert/evaluation/radial_borders.h"
#include "known_cameras.h"
#include "random_model.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace fca {
namespace {

using internal::Line;
using internal::LineSpan;
using internal::RadialBorders;

RC_GTEST_PROP(RadialBorders, LieWhereTheModelHasThatAngle, ()) {
  const CameraModel model = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  const double last = max_angle(model);
  const double angle = last * (*rc::gen::inRange(1, 90)) / 100.0;
  const std::vector<double> angles = {angle};
  const std::optional<RadialBorders> borders = RadialBorders::of(model, angles);
  RC_CLASSIFY(borders.has_value(), "radial");
  RC_PRE(borders.has_value());
  const auto place = [] { return static_cast<double>(*rc::gen::inRange(-200, 900)); };
  const Line line = {{place(), place()}, {place(), place()}};
  RC_PRE(line.length() > 1.0);
  const LineSpan inside = borders->among_circles(line).inside(borders->radii().front());
  for (const double end : {inside.begin, inside.end}) {
    if (!(end > 0.0 && end < 1.0)) continue;
    const std::optional<Ray> ray = unproject(model, line.at(end));
    RC_ASSERT(ray.has_value());
    RC_ASSERT(std::abs(angle_from_axis(*ray) - angle) < 1e-6);
  }
  // Nothing is crossed but there.
  for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const std::optional<Ray> ray = unproject(model, line.at(at));
    const double seen = ray ? angle_from_axis(*ray) : last;
    if (std::abs(seen - angle) > 1e-6) RC_ASSERT(inside.holds(at) == (seen < angle));
  }
}

TEST(RadialBorders, AreNotThoseOfTangentialDistortion) {
  const std::vector<double> angles = {0.3};
  EXPECT_FALSE(RadialBorders::of(test::euroc().model, angles));
  EXPECT_TRUE(RadialBorders::of(test::kalibr_ds().model, angles));
  const Lens somebody_elses([](const Pixel&) { return std::optional<Ray>(Ray{0.0, 0.0, 1.0}); }, {{1.0, 1.0}, {0.0, 0.0}});
  EXPECT_FALSE(RadialBorders::of(somebody_elses, angles));
}

}  // namespace
}  // namespace fca
