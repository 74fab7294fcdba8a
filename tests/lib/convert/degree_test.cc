// SPDX-License-Identifier: BSD-3-Clause
// The degree of a polynomial that a camera is fitted as: the lowest that is nearly as good as any, or the one asked for.
#include "known_cameras.h"

#include <fca/code.h>
#include <fca/convert/convert.h>
#include <fca/models/ocamcalib_parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fca {
namespace {

struct Case {
  const char* name;
  Camera camera;
  std::optional<double> max_angle_deg;
};

std::vector<Case> cases() {
  return {{"euroc", test::euroc(), {}},
          {"tumvi", test::tumvi(), 97.5},
          {"t265", test::t265_like(), 83.0},
          {"woodscape", test::woodscape_front(), 95.0},
          {"lens_220", test::lens_220(), 110.0}};
}

Conversion converted(const Case& each, std::optional<int> degree) {
  ConvertOptions options;
  options.model = "ocamcalib";
  options.degree = degree;
  options.bound = false;
  if (each.max_angle_deg) options.max_angle_rad = *each.max_angle_deg * test::kRadians;
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(each.camera, options, diagnostics);
  EXPECT_TRUE(conversion) << each.name;
  return conversion ? *conversion : Conversion();
}

ConversionReport report(const Case& each, std::optional<int> degree) { return converted(each, degree).report; }

/// Does the polynomial turn inside the image, behind what it was fitted to?
bool turns_inside(const Conversion& conversion) {
  const ImageSize size = *conversion.camera.image_size;
  return !unproject(conversion.camera.model, {0.0, 0.0}) ||
         !unproject(conversion.camera.model, {size.width - 1.0, size.height - 1.0});
}

TEST(Degree, IsTheLowestThatIsNearlyAsGoodAsAny) {
  constexpr double kGoodEnoughPx = 0.01;
  const ModelInfo& target = *find_model("ocamcalib");
  for (const Case& each : cases()) {
    const Conversion best_of_all = converted(each, {});
    const ConversionReport& chosen = best_of_all.report;
    if (turns_inside(best_of_all)) continue;
    double best = HUGE_VAL;
    for (int degree = target.least_degree; degree <= target.most_degree; ++degree) {
      const Conversion other = converted(each, degree);
      const ConversionReport& with = other.report;
      if (turns_inside(other)) continue;
      EXPECT_EQ(with.degree, degree);
      const double rms = with.statistics.error.rms;
      best = std::min(best, rms);
      const bool is_lower = degree < chosen.degree;
      EXPECT_TRUE(degree != chosen.degree || rms == chosen.statistics.error.rms) << each.name;
      EXPECT_TRUE(!is_lower || rms > kGoodEnoughPx) << each.name << ": degree " << degree << " is good enough";
      EXPECT_GE(with.statistics.coverage.scored, chosen.statistics.coverage.scored - 2e-3) << each.name;
    }
    EXPECT_LE(chosen.statistics.error.rms, std::max(1.1 * best, kGoodEnoughPx)) << each.name;
  }
}

// A wide lens needs more than the toolbox's default: what independent fits gain by degree 8 (tens of times) is gained.
TEST(Degree, GainsMuchOnAWideLens) {
  for (const Case& each : cases()) {
    if (each.max_angle_deg.value_or(0.0) < 90.0) continue;
    EXPECT_LT(report(each, {}).statistics.error.rms, 0.5 * report(each, 4).statistics.error.rms) << each.name;
  }
}

TEST(Degree, IsRefusedWhereThereIsNoneToChoose) {
  for (const auto& [model, degree] : {std::pair("kb4", 4), std::pair("ocamcalib", 3), std::pair("ocamcalib", 9)}) {
    ConvertOptions options;
    options.model = model;
    options.degree = degree;
    Diagnostics diagnostics;
    EXPECT_FALSE(convert(test::euroc(), options, diagnostics)) << model << degree;
    EXPECT_TRUE(diagnostics.has_errors());
  }
}

}  // namespace
}  // namespace fca
