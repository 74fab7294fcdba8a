// SPDX-License-Identifier: BSD-3-Clause
// Many rays at once have the pixels that each has alone, to 1e-9 px, and the same rays have none.
#include "../convert/random_model.h"

#include <fca/models/camera_model.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace fca {
namespace {

/// Rays up to `largest_rad` from the axis, each `length` long, as x y z x y z ...
std::vector<double> fan(double largest_rad, double length) {
  constexpr int kAngles = 48;
  constexpr int kAround = 32;
  std::vector<double> rays;
  for (int i = 0; i <= kAngles; ++i) {
    const double angle = largest_rad * i / kAngles;
    for (int j = 0; j < kAround; ++j) {
      const double around = 2.0 * std::numbers::pi * j / kAround;
      for (const double part : {std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), std::cos(angle)})
        rays.push_back(length * part);
    }
  }
  return rays;
}

/// Whether project_all() finds for each ray what project() finds. Far outside any image a pixel is very sensitive to its ray,
/// and only has to be there.
bool finds_the_same(const CameraModel& model, const std::vector<double>& rays) {
  constexpr double kSamePx = 1e-9;
  constexpr double kFarPx = 1e4;
  std::vector<double> pixels(rays.size() / 3 * 2);
  project_all(model, rays, pixels);
  bool same = true;
  for (std::size_t i = 0; i < rays.size() / 3; ++i) {
    const double* found = &pixels[2 * i];
    const std::optional<Pixel> pixel = project(model, {rays[3 * i], rays[3 * i + 1], rays[3 * i + 2]});
    if (!pixel) {
      same = same && std::isnan(found[0]) && std::isnan(found[1]);
      continue;
    }
    const bool is_far = std::hypot((*pixel)[0], (*pixel)[1]) > kFarPx;
    for (std::size_t axis = 0; axis < pixel->size(); ++axis)
      same = same && (is_far ? std::isfinite(found[axis]) : std::abs(found[axis] - (*pixel)[axis]) <= kSamePx);
  }
  return same;
}

RC_GTEST_PROP(ProjectAll, FindsForManyRaysWhatItFindsForEach, ()) {
  const CameraModel model = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  RC_ASSERT(
      finds_the_same(model, fan(*rc::gen::element(0.3, 1.2, 1.57, 2.5, std::numbers::pi), *rc::gen::element(1e-3, 1.0, 40.0))));
}

RC_GTEST_PROP(ProjectAll, FindsTheEndOfTheModelWhereItIs, ()) {
  const CameraModel model = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  const double end = max_angle(model);
  for (const double off : {-1e-6, -1e-9, 0.0, 1e-9, 1e-6})
    RC_ASSERT(finds_the_same(model, fan(std::min(end + off, std::numbers::pi), 1.0)));
}

RC_GTEST_PROP(ProjectAll, ARayThatIsNoRayHasNoPixelAndHarmsNoOther, ()) {
  const CameraModel model = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  std::vector<double> rays = fan(1.0, 1.0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity, 1e308, 1e-320, 0.0})
    rays[*rc::gen::inRange<std::size_t>(0, rays.size())] = odd;
  const std::size_t nowhere = 3 * *rc::gen::inRange<std::size_t>(0, rays.size() / 3);
  for (std::size_t axis = 0; axis < 3; ++axis) rays[nowhere + axis] = 0.0;
  RC_ASSERT(finds_the_same(model, rays));
}

}  // namespace
}  // namespace fca
