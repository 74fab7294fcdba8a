// SPDX-License-Identifier: BSD-3-Clause
// Does a fit reach the optimum that the target model can reach (floors.h)?
#include "floors.h"

#include <fca/convert/convert.h>

#include <gtest/gtest.h>

#include <string>

namespace fca {
namespace {

using test::Floor;

class FloorTest : public testing::TestWithParam<Floor> {};

TEST_P(FloorTest, FitReachesTheOptimum) {
  const Floor& floor = GetParam();
  ConvertOptions options;
  options.model = floor.target;
  options.every_pixel = true;
  options.bound = false;
  // The floors of a polynomial are those of its lowest degree.
  if (const int least = find_model(floor.target)->least_degree; least > 0) options.degree = least;
  if (floor.max_angle_deg) options.max_angle_rad = *floor.max_angle_deg * test::kRadians;
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(floor.camera, options, diagnostics);
  ASSERT_TRUE(conversion);
  EXPECT_TRUE(diagnostics.entries().empty());
  const ErrorStatistics& j = conversion->report.statistics;
  EXPECT_LE(j.error.rms, 1.005 * (floor.rms + floor.half_digit));
  // Some of the prototypes' radtan fits can be beaten by 4 %; more than that would mean that something was not scored.
  EXPECT_GE(j.error.rms, 0.95 * (floor.rms - floor.half_digit));
  EXPECT_EQ(j.coverage.unrepresentable, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Cameras, FloorTest, testing::ValuesIn(test::floors()), [](const testing::TestParamInfo<Floor>& floor) {
  std::string name = std::string(floor.param.camera_name) + "_" + floor.param.target;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
});

}  // namespace
}  // namespace fca
