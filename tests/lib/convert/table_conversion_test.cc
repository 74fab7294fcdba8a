// SPDX-License-Identifier: BSD-3-Clause
// A lens that is known as a table of rays alone is converted at the optimum over the table.
#include "known_cameras.h"

#include <fca/code.h>
#include <fca/convert/convert.h>
#include <fca/convert/ray_table.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fca {
namespace {

/// A camera as the rays of a lattice of its pixels, up to that angle from the axis.
Camera as_table(Camera camera, double max_angle_deg, int columns = 30) {
  const ImageSize size = *camera.image_size;
  const int rows = std::max(2, columns * size.height / size.width);
  std::vector<Correspondence> table;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const Pixel pixel = {(size.width - 1.0) * i / (columns - 1), (size.height - 1.0) * j / (rows - 1)};
      const std::optional<Ray> ray = unproject(camera.model, pixel);
      if (ray && angle_from_axis(*ray) <= max_angle_deg * test::kRadians) table.push_back({*ray, pixel, 1.0});
    }
  }
  for (Correspondence& entry : table) entry.weight /= static_cast<double>(table.size());
  const LensCentre centre = centre_of(table).value();
  camera.rays = std::move(table);
  camera.model = Intrinsics<Pinhole>{{centre.focal[0], centre.focal[1], centre.point[0], centre.point[1]}};
  return camera;
}

ConvertOptions to(std::string model) {
  ConvertOptions options;
  options.model = std::move(model);
  return options;
}

bool has(const Diagnostics& diagnostics, Code code) {
  return std::ranges::any_of(diagnostics.entries(), [code](const Diagnostic& entry) { return entry.facts.code == code; });
}

struct Case {
  Camera camera;
  double max_angle_deg;
};

std::vector<Case> cases() {
  return {{test::tumvi(), 90.0}, {test::euroc(), 90.0}, {test::kalibr_ds(), 100.0}, {test::woodscape_front(), 95.0}};
}

TEST(TableConversion, FindsTheModelThatTheTableWasMadeWith) {
  for (const Case& each : cases()) {
    const std::string id(model_info(each.camera.model).id);
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = convert(as_table(each.camera, each.max_angle_deg), to(id), diagnostics);
    ASSERT_TRUE(conversion) << id;
    EXPECT_LE(conversion->report.statistics.error.max, 1e-5) << id;
    EXPECT_EQ(conversion->report.from_model, "rays");
    EXPECT_FALSE(conversion->report.exact);
    EXPECT_TRUE(std::isinf(conversion->report.statistics.error.bound)) << "between rays nothing is known";
    EXPECT_TRUE(conversion->camera.rays.empty());
    EXPECT_TRUE(has(diagnostics, Code::kOnlyRaysCompared));
  }
}

// The conversion of the camera itself is one more candidate: the optimum over the table is never worse there.
TEST(TableConversion, IsAtLeastAsGoodOnTheTableAsTheConversionOfTheCamera) {
  for (const Case& each : cases()) {
    const Camera table = as_table(each.camera, each.max_angle_deg);
    for (const char* model : {"kb4", "eucm", "ds", "ocamcalib"}) {
      ConvertOptions options = to(model);
      options.max_angle_rad = each.max_angle_deg * test::kRadians;
      if (options.model == "ocamcalib") options.degree = 6;
      Diagnostics diagnostics;
      const std::optional<Conversion> by_table = convert(table, options, diagnostics);
      const std::optional<Conversion> by_model = convert(each.camera, options, diagnostics);
      ASSERT_TRUE(by_table && by_model) << model;
      const CameraModel& other = by_model->camera.model;
      const ErrorSummary rival = evaluate(table.rays, [&other](const Ray& ray) { return project(other, ray); });
      EXPECT_LE(by_table->report.statistics.error.rms, 1.0005 * rival.rms + 1e-6) << model;
      EXPECT_NEAR(by_table->report.statistics.coverage.scored + by_table->report.statistics.coverage.unrepresentable, 1.0,
                  1e-9);
    }
  }
}

TEST(TableConversion, APerspectiveModelIsFittedUpToASmallerAngleWithAWarning) {
  const Camera table = as_table(test::lens_220(), 110.0, 60);
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(table, to("radtan"), diagnostics);
  ASSERT_TRUE(conversion);
  EXPECT_TRUE(conversion->report.angle_reduced);
  EXPECT_TRUE(has(diagnostics, Code::kTargetCannotReach));
  EXPECT_LE(conversion->report.statistics.error.rms, 1.0);
  EXPECT_GT(conversion->report.statistics.coverage.unrepresentable, 0.1);
}

TEST(TableConversion, CountsWhatLiesInTheImageAndInsideTheAngle) {
  Camera table = as_table(test::tumvi(), 90.0);
  ConvertOptions options = to("kb4");
  options.max_angle_rad = 40.0 * test::kRadians;
  // A pixel that no image has, and a ray beyond the angle, which is wrong.
  table.rays.push_back({{0.0, 0.0, 1.0}, {-1000.0, 0.0}, table.rays.front().weight});
  for (Correspondence& entry : table.rays) {
    if (angle_from_axis(entry.ray) > 45.0 * test::kRadians) entry.pixel[0] += 20.0;
  }
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(table, options, diagnostics);
  ASSERT_TRUE(conversion);
  EXPECT_LE(conversion->report.statistics.error.max, 1e-5);
  EXPECT_LE(conversion->report.scored_to_deg, 40.0);
}

TEST(TableConversion, RefusesWhatATableCannotServe) {
  const Camera table = as_table(test::tumvi(), 90.0);
  ConvertOptions options = to("kb4");
  options.objective = Objective::kMax;
  Diagnostics of_max;
  EXPECT_FALSE(convert(table, options, of_max));
  EXPECT_TRUE(has(of_max, Code::kRaysFittedForRms));

  options = to("kb4");
  options.max_angle_rad = 1e-3;
  Diagnostics of_few;
  EXPECT_FALSE(convert(table, options, of_few));
  EXPECT_TRUE(has(of_few, Code::kTooFewRaysToFit));
}

}  // namespace
}  // namespace fca
