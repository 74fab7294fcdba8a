// SPDX-License-Identifier: BSD-3-Clause
// Objective::kMax: is the worst pixel as small as a camera near the least-squares fit can make it, and what is it paid with?
#include "known_cameras.h"

#include <fca/convert/convert.h>
#include <fca/convert/field_of_view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fca {
namespace {

struct Case {
  const char* camera_name;
  Camera camera;
  std::optional<double> max_angle_deg;
  const char* target;
};

std::vector<Case> cases() {
  using namespace test;
  std::vector<Case> all;
  const auto add = [&](const char* name, const Camera& camera, std::optional<double> deg, std::vector<const char*> targets) {
    for (const char* target : targets) all.push_back({name, camera, deg, target});
  };
  add("kalibr_ds", kalibr_ds(), {},
      {"pinhole", "radtan", "rational", "kb4", "ucm", "eucm", "mei", "fov", "ocamcalib", "woodscape"});
  add("kalibr_eucm", kalibr_eucm(), {}, {"ucm", "ds", "kb4", "radtan"});
  add("kalibr_kb4", kalibr_kb4(), {}, {"ucm", "eucm", "ds", "radtan", "rational", "ocamcalib"});
  add("euroc", euroc(), {}, {"ucm", "eucm", "ds", "kb4", "ocamcalib"});
  add("tumvi", tumvi(), 97.5, {"ucm", "eucm", "ds", "mei", "ocamcalib", "woodscape"});
  add("tumvi_80", tumvi(), 80.0, {"rational"});
  add("tumvi_60", tumvi(), 60.0, {"radtan"});
  add("tumvi_image", tumvi(), {}, {"ucm", "eucm", "ds", "radtan", "rational"});
  add("t265_like", t265_like(), 83.0, {"ucm", "eucm", "ds", "ocamcalib"});
  add("lens_220", lens_220(), 110.0, {"ucm", "eucm", "ds", "ocamcalib"});
  add("ocamcalib", ocamcalib_sample(), 95.0, {"ucm", "eucm", "ds", "kb4"});
  add("woodscape", woodscape_front(), 95.0, {"ucm", "eucm", "ds", "kb4", "ocamcalib"});
  add("woodscape_80", woodscape_front(), 80.0, {"rational"});
  add("rational_lens", rational_lens(), {}, {"ucm", "eucm", "ds", "kb4", "radtan", "ocamcalib"});
  return all;
}

ConvertOptions options_of(const Case& c, Objective objective) {
  ConvertOptions options;
  options.model = c.target;
  options.objective = objective;
  if (c.max_angle_deg) options.max_angle_rad = *c.max_angle_deg * test::kRadians;
  return options;
}

Conversion converted(const Case& c, Objective objective) {
  Diagnostics diagnostics;
  std::optional<Conversion> conversion = convert(c.camera, options_of(c, objective), diagnostics);
  EXPECT_TRUE(conversion);
  return conversion ? *std::move(conversion) : Conversion();
}

/// Rays and pixels on a lattice of our own, border included, as far from the axis as the conversion is scored.
std::vector<Correspondence> dense_lattice(const Case& c, const Conversion& conversion) {
  constexpr int kSpacing = 8;  // px
  Diagnostics diagnostics;
  std::optional<FieldOfView> field_of_view =
      field_of_view_of(c.camera, options_of(c, Objective::kMax).max_angle_rad, diagnostics);
  constexpr double kRounding = 1e-12;
  field_of_view->max_angle_rad =
      std::min(field_of_view->max_angle_rad, (1.0 + kRounding) * conversion.report.scored_to_deg * test::kRadians);
  std::vector<Correspondence> points;
  const auto side = [](int pixels) {
    std::vector<double> positions;
    for (int i = 0; i < pixels - 1; i += kSpacing) positions.push_back(i);
    positions.push_back(pixels - 1);
    return positions;
  };
  for (const double v : side(c.camera.image_size->height)) {
    for (const double u : side(c.camera.image_size->width)) {
      const std::optional<Ray> ray = field_of_view->ray(c.camera.model, {u, v});
      if (ray && project(conversion.camera.model, *ray)) points.push_back({*ray, {u, v}, 1.0});
    }
  }
  return points;
}

/// Infinite where one has no pixel.
double error_at(const CameraModel& model, const Correspondence& point) {
  const std::optional<Pixel> pixel = project(model, point.ray);
  if (!pixel) return std::numeric_limits<double>::infinity();
  return std::hypot((*pixel)[0] - point.pixel[0], (*pixel)[1] - point.pixel[1]);
}

double largest_error(const CameraModel& model, std::span<const Correspondence> points) {
  double largest = 0.0;
  for (const Correspondence& point : points) largest = std::max(largest, error_at(model, point));
  return largest;
}

class MinimaxTest : public testing::TestWithParam<Case> {};

TEST_P(MinimaxTest, TheWorstPixelIsNeverWorseAndIsPaidInRms) {
  const Conversion rms = converted(GetParam(), Objective::kRms);
  const Conversion max = converted(GetParam(), Objective::kMax);
  const ErrorStatistics& before = rms.report.statistics;
  const ErrorStatistics& after = max.report.statistics;
  EXPECT_LE(after.error.max, before.error.max);
  // The least-squares fit is one on samples: within half a percent of the image's optimum.
  EXPECT_GE(after.error.rms, before.error.rms / 1.005);
  EXPECT_GE(after.coverage.scored, before.coverage.scored);
  EXPECT_TRUE(validate(max.camera.model).empty());

  EXPECT_EQ(rms.report.objective, Objective::kRms);
  EXPECT_FALSE(rms.report.rms_fit);
  EXPECT_EQ(max.report.objective, Objective::kMax);
  ASSERT_TRUE(max.report.rms_fit);
  EXPECT_EQ(max.report.rms_fit->rms_px, before.error.rms);
  EXPECT_EQ(max.report.rms_fit->max_px, before.error.max);
  EXPECT_EQ(max.report.rms_fit->kept, max.camera.model == rms.camera.model);
}

TEST_P(MinimaxTest, NoCameraNearbyHasASmallerWorstPixel) {
  const Case& c = GetParam();
  const Conversion max = converted(c, Objective::kMax);
  const CameraModel& best = max.camera.model;
  const std::vector<Correspondence> points = dense_lattice(c, max);
  const double largest = largest_error(best, points);
  // The unit of each parameter: what moves a pixel by as much as the largest error.
  std::vector<double> unit(parameter_values(best).size());
  for (std::size_t i = 0; i < unit.size(); ++i) {
    constexpr double kSmall = 1e-7;
    CameraModel moved = best;
    double& value = parameter_values(moved)[i];
    const double change = kSmall * (1.0 + std::abs(value));
    value += change;
    double furthest = 0.0;
    for (const Correspondence& point : points) {
      const std::optional<Pixel> from = project(best, point.ray);
      const std::optional<Pixel> to = project(moved, point.ray);
      if (from && to) furthest = std::max(furthest, std::hypot((*to)[0] - (*from)[0], (*to)[1] - (*from)[1]));
    }
    unit[i] = furthest > 0.0 ? change * largest / furthest : 0.0;
  }
  constexpr int kDirections = 20;
  constexpr double kPercent = 0.01;
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (int k = 0; k < kDirections; ++k) {
    std::vector<double> direction(unit.size());
    for (std::size_t i = 0; i < unit.size(); ++i) direction[i] = unit[i] * normal(random);
    for (const double step : {1.0, 0.3, 0.1, 0.01}) {
      CameraModel moved = best;
      for (std::size_t i = 0; i < unit.size(); ++i) {
        // What fits leave alone is not theirs to gain from.
        if (parameter_values(best)[i] != 0.0) parameter_values(moved)[i] += step * direction[i];
      }
      if (!validate(moved).empty()) continue;
      EXPECT_GE(largest_error(moved, points), (1.0 - kPercent) * largest) << "step " << step << " in direction " << k;
    }
  }
}

// Kolmogorov's criterion: where no change of the parameters lowers all of the largest errors, their gradients have 0 in their
// convex hull. For fx, fy, cx, cy and a lens parameter three places are too few, but in degenerate positions.
TEST_P(MinimaxTest, TheLargestErrorIsAttainedAtSeveralPlaces) {
  const Case& c = GetParam();
  const Conversion max = converted(c, Objective::kMax);
  EXPECT_FALSE(max.report.rms_fit->kept) << "least squares does not level the largest errors";
  const std::vector<Correspondence> points = dense_lattice(c, max);
  const double apart = 0.1 * std::max(c.camera.image_size->width, c.camera.image_size->height);
  const auto places = [&](const CameraModel& model) {
    constexpr double kNearlyEqual = 0.97;
    const double largest = largest_error(model, points);
    std::vector<Pixel> found;
    for (const Correspondence& point : points) {
      if (error_at(model, point) < kNearlyEqual * largest) continue;
      const auto near = [&](const Pixel& p) { return std::hypot(p[0] - point.pixel[0], p[1] - point.pixel[1]) < apart; };
      if (std::ranges::none_of(found, near)) found.push_back(point.pixel);
    }
    return found.size();
  };
  EXPECT_GE(places(max.camera.model), 4U);
}

INSTANTIATE_TEST_SUITE_P(Cameras, MinimaxTest, testing::ValuesIn(cases()), [](const testing::TestParamInfo<Case>& c) {
  return std::string(c.param.camera_name) + "_to_" + c.param.target;
});

TEST(Minimax, RangesOfTheTargetAreKept) {
  // EuRoC's lens wants less alpha than that, and a k3.
  ConvertOptions options;
  options.objective = Objective::kMax;
  options.model = "eucm";
  options.ranges = {{"alpha", 0.501, 1.0}};
  Diagnostics diagnostics;
  const std::optional<Conversion> eucm = convert(test::euroc(), options, diagnostics);
  ASSERT_TRUE(eucm);
  EXPECT_TRUE(within(eucm->camera.model, options.ranges));
  EXPECT_LT(eucm->report.statistics.error.max, eucm->report.rms_fit->max_px);
  EXPECT_EQ(eucm->report.at_bound, std::vector<std::string>{"alpha"});

  options.model = "radtan";
  options.ranges = {{"k3", 0.0, 0.0}};
  const std::optional<Conversion> radtan = convert(test::kalibr_kb4(), options, diagnostics);
  ASSERT_TRUE(radtan);
  EXPECT_EQ(parameter(radtan->camera.model, "k3").value(), 0.0);
  EXPECT_LT(radtan->report.statistics.error.max, radtan->report.rms_fit->max_px);
  EXPECT_TRUE(radtan->report.at_bound.empty()) << "a fixed parameter is no bound that was hit";
}

TEST(Minimax, WhatIsExactStaysExact) {
  Diagnostics diagnostics;
  ConvertOptions options;
  options.objective = Objective::kMax;
  for (const Camera& camera : {test::kalibr_ds(), test::euroc(), test::tumvi()}) {
    options.model = model_info(camera.model).id;
    const std::optional<Conversion> same = convert(camera, options, diagnostics);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->camera, camera);
    EXPECT_FALSE(same->report.rms_fit);
  }
  // mei describes this radtan lens, ds this eucm: by whatever way, nothing is left to polish.
  constexpr double kExact = 1e-9;  // px
  options.model = "mei";
  const std::optional<Conversion> mei = convert(test::euroc(), options, diagnostics);
  ASSERT_TRUE(mei);
  EXPECT_LE(mei->report.statistics.error.max, kExact);
  options.model = "ds";
  const Camera symmetric = test::make_camera(Intrinsics<Eucm>{{300, 300, 319.5, 239.5, 0.6, 1.0}}, {640, 480});
  const std::optional<Conversion> ds = convert(symmetric, options, diagnostics);
  ASSERT_TRUE(ds);
  EXPECT_LE(ds->report.statistics.error.max, kExact);
}

TEST(Minimax, TheSameQuestionHasTheSameAnswer) {
  const Case c = {"woodscape", test::woodscape_front(), 95.0, "kb4"};
  EXPECT_EQ(converted(c, Objective::kMax).camera, converted(c, Objective::kMax).camera);
}

// The least-squares fit of this one is summed over pixels, as its error sits in a corner; the other is no worse for being
// summed over a lattice.
TEST(Minimax, ASteepFitIsNotKept) {
  const Camera camera = test::make_camera(Intrinsics<Kb4>{{75.1135380958, 75.1135380958, 79.5, 41.0, -0.0333760489974,
                                                           -0.0119854105505, 0.00650021895677, -0.00726882954621}},
                                          {159, 82});
  const Case steep = {"steep", camera, 123.5337, "rational"};
  const Conversion rms = converted(steep, Objective::kRms);
  const Conversion max = converted(steep, Objective::kMax);
  ASSERT_TRUE(max.report.rms_fit);
  EXPECT_FALSE(max.report.rms_fit->kept);
  EXPECT_LT(max.report.statistics.error.max, 0.1 * rms.report.statistics.error.max);
}

}  // namespace
}  // namespace fca
