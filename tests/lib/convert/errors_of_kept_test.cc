// SPDX-License-Identifier: BSD-3-Clause
// Without ConvertOptions::errors_of_kept the coverage is what it is with it.
#include "known_cameras.h"

#include <fca/convert/convert.h>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

TEST(ErrorsOfKept, AreLeftOutOnlyOfTheSameModelAndAWholeImage) {
  ConvertOptions options;
  options.model = "kb4";
  Diagnostics diagnostics;
  const Camera camera = make_camera(Intrinsics<Kb4>{{190.9, 190.8, 254.9, 256.9, 0.0034, 0.0007, -0.002, 0.0002}}, {512, 512});
  const std::optional<Conversion> with = convert(camera, options, diagnostics);
  options.errors_of_kept = false;
  const std::optional<Conversion> without = convert(camera, options, diagnostics);
  ASSERT_TRUE(with && without);
  const Coverage& full = with->report.statistics.coverage;
  const Coverage& alone = without->report.statistics.coverage;
  EXPECT_FALSE(with->report.statistics.bands.empty());
  EXPECT_TRUE(without->report.statistics.bands.empty());
  EXPECT_EQ(full.scored, alone.scored);
  EXPECT_EQ(full.outside_lens, alone.outside_lens);
  EXPECT_EQ(full.unrepresentable, alone.unrepresentable);
  EXPECT_EQ(full.max_angle_deg, alone.max_angle_deg);
  EXPECT_EQ(full.why, alone.why);
  EXPECT_EQ(with->report.scored_to_deg, without->report.scored_to_deg);
  options.max_angle_rad = 50.0 * kRadians;
  const std::optional<Conversion> cut = convert(camera, options, diagnostics);
  ASSERT_TRUE(cut);
  EXPECT_LT(cut->report.statistics.coverage.scored, 1.0);
}

}  // namespace
}  // namespace fca::test
