// SPDX-License-Identifier: BSD-3-Clause
// An image circle is the field of view: nothing outside it counts, wherever its centre is.
#include "known_cameras.h"

#include <fca/convert/convert.h>
#include <fca/convert/evaluate.h>
#include <fca/convert/field_of_view.h>

#include <gtest/gtest.h>

namespace fca {
namespace {

std::optional<Conversion> converted(const Camera& camera, std::string model, std::optional<double> max_angle_rad = {}) {
  ConvertOptions options;
  options.model = std::move(model);
  options.max_angle_rad = max_angle_rad;
  options.every_pixel = true;
  Diagnostics diagnostics;
  return convert(camera, options, diagnostics);
}

Camera eccentric() { return test::with_image_circle(test::tumvi(), {215.0, 270.0}, 210.0); }

TEST(LensCircle, ThePixelsInItAreTheFieldOfView) {
  const Camera camera = eccentric();
  long long inside = 0;
  for (int v = 0; v < camera.image_size->height; ++v) {
    for (int u = 0; u < camera.image_size->width; ++u)
      inside += camera.lens_circle->contains({static_cast<double>(u), static_cast<double>(v)}) ? 1 : 0;
  }
  const std::optional<Conversion> conversion = converted(camera, "ds");
  ASSERT_TRUE(conversion);
  const Coverage& coverage = conversion->report.statistics.coverage;
  EXPECT_EQ(coverage.scored_pixels + coverage.unrepresentable_pixels, inside);
  EXPECT_NEAR(coverage.scored + coverage.unrepresentable + coverage.outside_lens, 1.0, 1e-12);
  ASSERT_TRUE(coverage.circle);
  EXPECT_EQ(coverage.why, camera.lens_circle->why);
}

// The largest angle is that of the pixel of the circle furthest from the axis: a smaller one would cut what is lit.
TEST(LensCircle, ItsLargestAngleIsThatOfItsFurthestPixel) {
  const Camera camera = eccentric();
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  double furthest = 0.0;
  constexpr int kAzimuths = 100'000;
  for (int i = 0; i < kAzimuths; ++i) {
    const Pixel pixel = camera.lens_circle->rim(2.0 * std::numbers::pi * i / kAzimuths);
    const std::optional<Ray> ray = unproject(camera.model, pixel);
    if (ray && camera.image_size->holds(pixel)) furthest = std::max(furthest, angle_from_axis(*ray));
  }
  EXPECT_GE(field_of_view->max_angle_rad, furthest);
  EXPECT_LE(field_of_view->max_angle_rad, furthest * (1.0 + 1e-8));
}

TEST(LensCircle, NeedsNotHoldThePrincipalPoint) {
  const Camera camera = test::with_image_circle(test::tumvi(), {60.0, 60.0}, 10.0);
  for (const char* target : {"ucm", "eucm", "ds", "mei", "ocamcalib"}) {
    const std::optional<Conversion> conversion = converted(camera, target);
    ASSERT_TRUE(conversion) << target;
    EXPECT_LE(conversion->report.statistics.error.rms, 0.02) << target;
    EXPECT_EQ(conversion->report.statistics.coverage.unrepresentable, 0.0) << target;
  }
}

// A fit to what is lit is the best there: one to the cone around it, or to the whole image, bends for what is dark.
TEST(LensCircle, AFitToItIsTheBestInIt) {
  const Camera camera = eccentric();
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  Camera without = camera;
  without.lens_circle.reset();
  for (const char* model : {"ucm", "eucm", "ds", "kb4"}) {
    SCOPED_TRACE(model);
    const std::optional<Conversion> lit = converted(camera, model);
    const std::optional<Conversion> cone = converted(without, model, field_of_view->max_angle_rad);
    const std::optional<Conversion> image = converted(without, model);
    ASSERT_TRUE(lit && cone && image);
    const auto rms_in_circle = [&](const CameraModel& target) {
      return evaluate(camera.model, target, *field_of_view, {.every_pixel = true}).error.rms;
    };
    constexpr double kAlike = 1.0005;
    EXPECT_LE(rms_in_circle(lit->camera.model), kAlike * rms_in_circle(cone->camera.model));
    EXPECT_LE(rms_in_circle(lit->camera.model), kAlike * rms_in_circle(image->camera.model));
  }
}

TEST(LensCircle, AroundTheAxisItIsAMaxAngle) {
  const Camera tumvi = test::tumvi();
  const Camera camera = test::with_image_circle(tumvi, principal_point(tumvi.model), 200.0);
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  const std::optional<Conversion> lit = converted(camera, "eucm");
  const std::optional<Conversion> cone = converted(tumvi, "eucm", field_of_view->max_angle_rad);
  ASSERT_TRUE(lit && cone);
  const ErrorStatistics& a = lit->report.statistics;
  const ErrorStatistics& b = cone->report.statistics;
  EXPECT_NEAR(a.error.rms, b.error.rms, 1e-3 * b.error.rms);
  EXPECT_NEAR(a.error.max, b.error.max, 1e-2 * b.error.max);
  EXPECT_NEAR(a.coverage.scored, b.coverage.scored, 1e-3);
}

TEST(LensCircle, OneAroundTheWholeImageCutsNothing) {
  const Camera tumvi = test::tumvi();
  const Camera camera = test::with_image_circle(tumvi, {240.0, 260.0}, 1000.0);
  const std::optional<Conversion> lit = converted(camera, "eucm");
  const std::optional<Conversion> whole = converted(tumvi, "eucm");
  ASSERT_TRUE(lit && whole);
  EXPECT_EQ(lit->camera.model, whole->camera.model);
  EXPECT_FALSE(lit->report.statistics.coverage.circle);
}

// The worst pixel may be anywhere on the rim: it is there that the other objective makes it smaller.
TEST(LensCircle, ItsRimIsLookedAlongForTheWorstPixel) {
  const Camera camera = eccentric();
  ConvertOptions options;
  options.model = "eucm";
  options.objective = Objective::kMax;
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(conversion && field_of_view);
  ASSERT_TRUE(conversion->report.rms_fit);
  EXPECT_LT(conversion->report.statistics.error.max, conversion->report.rms_fit->max_px);
  constexpr int kAzimuths = 5'000;
  double worst = 0.0;
  for (int i = 0; i < kAzimuths; ++i) {
    LensCircle inner = *camera.lens_circle;
    inner.radius_px -= 1e-6;
    const Pixel pixel = inner.rim(2.0 * std::numbers::pi * i / kAzimuths);
    const std::optional<Ray> ray = field_of_view->ray(camera.model, pixel);
    const std::optional<Pixel> image = ray ? project(conversion->camera.model, *ray) : std::nullopt;
    if (image) worst = std::max(worst, std::hypot((*image)[0] - pixel[0], (*image)[1] - pixel[1]));
  }
  EXPECT_GE(conversion->report.statistics.error.max, worst * (1.0 - 1e-6));
  EXPECT_LE(conversion->report.statistics.error.bound, 1.1 * conversion->report.statistics.error.max + 1e-9);
}

}  // namespace
}  // namespace fca
