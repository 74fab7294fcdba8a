// SPDX-License-Identifier: BSD-3-Clause
#include "known_cameras.h"

#include <fca/convert/field_of_view.h>
#include <fca/convert/max_angle_table.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace fca {
namespace {

TEST(MaxAngleTable, ShowsWhatBlackCornersCost) {
  const Camera camera = test::tumvi();
  ConvertOptions options;
  options.model = "eucm";
  Diagnostics diagnostics;
  const std::vector<MaxAngleRow> table = max_angle_table(camera, options, diagnostics);
  EXPECT_TRUE(diagnostics.entries().empty());
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  ASSERT_GE(table.size(), 4u);
  EXPECT_DOUBLE_EQ(table[0].max_angle_deg, 90.0);
  EXPECT_DOUBLE_EQ(table[1].max_angle_deg, 95.0);
  EXPECT_DOUBLE_EQ(table.back().max_angle_deg, field_of_view->max_angle_rad / test::kRadians);
  for (std::size_t i = 1; i < table.size(); ++i) {
    EXPECT_GT(table[i].max_angle_deg, table[i - 1].max_angle_deg);
    EXPECT_GT(table[i].scored, table[i - 1].scored);
    EXPECT_GE(table[i].rms_px, table[i - 1].rms_px);
  }
  // LIMITS: 0.0226 px inside 97.5 degrees, 0.113 over the whole image.
  EXPECT_LT(table[1].rms_px, 0.0226);
  EXPECT_NEAR(table.back().rms_px, 0.113, 0.01);
  EXPECT_NEAR(table.back().scored, 1.0, 1e-12);

  // The report holds the same, if asked to.
  options.max_angle_table = true;
  const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
  ASSERT_TRUE(conversion);
  ASSERT_EQ(conversion->report.max_angles.size(), table.size());
  EXPECT_EQ(conversion->report.max_angles.back().rms_px, table.back().rms_px);
  EXPECT_DOUBLE_EQ(conversion->report.statistics.error.rms, table.back().rms_px);
}

/// Inside wider and wider angles the same target never scores less of the image, and says so where it ends earlier.
void expect_no_loss(const Camera& camera, std::string_view target, const std::vector<double>& angles_deg) {
  double before = 0.0;
  for (const double deg : angles_deg) {
    SCOPED_TRACE(camera.name + " " + std::string(target) + " " + std::to_string(deg));
    ConvertOptions options;
    options.model = target;
    options.max_angle_rad = deg * test::kRadians;
    options.bound = false;
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
    ASSERT_TRUE(conversion);
    const Coverage& coverage = conversion->report.statistics.coverage;
    EXPECT_GE(coverage.scored, before - 1e-3);
    const bool said = std::ranges::any_of(diagnostics.entries(), [](const Diagnostic& entry) {
      return id_of(entry) == "target-cannot-reach" || id_of(entry) == "folds-inside-image";
    });
    EXPECT_TRUE(said || coverage.unrepresentable <= 1e-3) << coverage.unrepresentable;
    before = std::max(before, coverage.scored);
  }
}

std::vector<double> steps(double from, double to, double step) {
  std::vector<double> result;
  for (double deg = from; deg <= to; deg += step) result.push_back(deg);
  return result;
}

// What does not only see ahead reaches as far as it can, whatever the error; radtan stays under 1 px. (Equidistant, all
// around.)
TEST(MaxAngleTable, OnlyAPerspectiveModelHasALimitOfTheError) {
  const Camera camera = test::make_camera(Intrinsics<Kb4>{{100, 100, 319.5, 319.5, 0, 0, 0, 0}}, {640, 640});
  for (const auto& [target, is_perspective] : {std::pair("ucm", false), std::pair("radtan", true)}) {
    ConvertOptions options;
    options.model = target;
    options.bound = false;
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
    ASSERT_TRUE(conversion) << target;
    EXPECT_TRUE(std::ranges::any_of(diagnostics.entries(), [](const Diagnostic& entry) {
      return id_of(entry) == "target-cannot-reach";
    })) << target;
    const ConversionReport& report = conversion->report;
    if (is_perspective) {
      EXPECT_LE(report.statistics.error.rms, 1.0);
    } else {
      EXPECT_GT(report.statistics.error.rms, 1.0) << target;
      EXPECT_GT(report.scored_to_deg, 120.0) << target;
    }
    expect_no_loss(camera, target, steps(60.0, 180.0, 15.0));
  }
}

TEST(MaxAngleTable, AWiderAngleNeverScoresLess) {
  for (const ModelInfo& target : all_models()) {
    for (const Camera& camera : {test::kalibr_ds(), test::euroc(), test::rational_lens()})
      expect_no_loss(camera, target.id, steps(20.0, 60.0, 8.0));
    for (const Camera& camera :
         {test::tumvi(), test::t265_like(), test::lens_220(), test::woodscape_front(), test::ocamcalib_sample()})
      expect_no_loss(camera, target.id, steps(55.0, 135.0, 10.0));
  }
}

// Where a plane gives up, and close to where every plane does.
TEST(MaxAngleTable, AWiderAngleNeverScoresLessOnAPlane) {
  for (const char* target : {"pinhole", "radtan", "rational"}) {
    for (const Camera& camera : {test::tumvi(), test::t265_like(), test::lens_220()}) {
      expect_no_loss(camera, target, steps(20.0, 30.0, 2.0));
      expect_no_loss(camera, target, steps(62.0, 68.0, 1.0));
      expect_no_loss(camera, target, steps(84.0, 92.0, 1.0));
    }
  }
}

/// Each row is what a conversion inside its angle says, whether the table made that conversion or saved it.
void expect_rows_are_conversions(const Camera& camera, std::string_view target) {
  ConvertOptions options;
  options.model = target;
  Diagnostics diagnostics;
  const std::optional<Conversion> whole = convert(camera, options, diagnostics);
  ASSERT_TRUE(whole);
  const std::vector<MaxAngleRow> table = max_angle_table(camera, options, whole->report, diagnostics);
  ASSERT_GE(table.size(), 4u);
  for (const MaxAngleRow& row : table) {
    SCOPED_TRACE(camera.name + " " + std::string(target) + " " + std::to_string(row.max_angle_deg));
    options.max_angle_rad = row.max_angle_deg * test::kRadians;
    const std::optional<Conversion> inside = convert(camera, options, diagnostics);
    ASSERT_TRUE(inside);
    const ErrorStatistics& statistics = inside->report.statistics;
    EXPECT_NEAR(row.rms_px, statistics.error.rms, 1e-3 * statistics.error.rms);
    EXPECT_NEAR(row.max_px, statistics.error.max, 1e-2 * statistics.error.max);
    EXPECT_NEAR(row.scored_to_deg, inside->report.scored_to_deg, 1e-3);
    EXPECT_NEAR(row.scored, statistics.coverage.scored, 1e-3);
    EXPECT_NEAR(row.unrepresentable, statistics.coverage.unrepresentable, 1e-3);
  }
  options.max_angle_rad.reset();
  // And so is what is worked out without the conversion at hand.
  const std::vector<MaxAngleRow> again = max_angle_table(camera, options, diagnostics);
  ASSERT_EQ(again.size(), table.size());
  for (std::size_t i = 0; i < table.size(); ++i) EXPECT_EQ(again[i].rms_px, table[i].rms_px) << target;
}

TEST(MaxAngleTable, IsOneFitForAPerspectiveTarget) {
  for (const char* target : {"pinhole", "radtan", "rational"}) expect_rows_are_conversions(test::tumvi(), target);
}

TEST(MaxAngleTable, IsOneFitBeyondTheAngleThatATargetDescribes) { expect_rows_are_conversions(test::t265_like(), "ucm"); }

TEST(MaxAngleTable, IsEmptyWithoutAChoice) {
  ConvertOptions options;
  options.model = "eucm";
  Diagnostics diagnostics;
  EXPECT_TRUE(max_angle_table(test::kalibr_ds(), options, diagnostics).empty());  // 57 degrees
  options.max_angle_rad = 97.5 * test::kRadians;
  EXPECT_TRUE(max_angle_table(test::tumvi(), options, diagnostics).empty());
  options.max_angle_rad.reset();
  options.model = "no such model";
  EXPECT_TRUE(max_angle_table(test::tumvi(), options, diagnostics).empty());
}

}  // namespace
}  // namespace fca
