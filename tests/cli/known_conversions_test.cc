// SPDX-License-Identifier: BSD-3-Clause
// A conversion that is remembered is the one that would be made.
#include "toolkit/convert/known_conversions.h"
#include "lib/convert/known_cameras.h"

#include <gtest/gtest.h>

namespace fca::test {
namespace {

std::vector<Message> facts_in(const Diagnostics& diagnostics) {
  std::vector<Message> facts;
  for (const Diagnostic& entry : diagnostics.entries()) facts.push_back(entry.facts);
  return facts;
}

TEST(KnownConversions, AreWhatWouldBeMade) {
  KnownConversions known;
  Camera renamed = tumvi();
  renamed.name = "other";
  Camera smaller = tumvi();
  smaller.image_size = ImageSize{400, 400};
  const ConvertOptions radtan = {.model = "radtan"};
  const ConvertOptions inside = {.model = "radtan", .max_angle_rad = 0.6};
  const ConvertOptions eucm = {.model = "eucm"};
  // Twice, so that each is remembered among the others.
  for (int round = 0; round < 2; ++round) {
    for (const Camera& camera : {tumvi(), renamed, smaller}) {
      for (const ConvertOptions& options : {radtan, inside, eucm}) {
        Diagnostics made;
        Diagnostics remembered;
        const std::optional<Conversion> expected = convert(camera, options, made);
        const std::optional<Conversion> conversion = known.convert(camera, options, remembered);
        ASSERT_TRUE(expected && conversion);
        EXPECT_EQ(conversion->camera, expected->camera);
        EXPECT_EQ(conversion->report.statistics.error.max, expected->report.statistics.error.max);
        EXPECT_EQ(facts_in(remembered), facts_in(made));
      }
    }
  }
}

TEST(KnownConversions, ThatFailedFailAgain) {
  KnownConversions known;
  for (int round = 0; round < 2; ++round) {
    Diagnostics found;
    EXPECT_FALSE(known.convert(tumvi(), {.model = "no-such-model"}, found));
    EXPECT_TRUE(found.has_errors());
  }
}

}  // namespace
}  // namespace fca::test
