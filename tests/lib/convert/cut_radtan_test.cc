// SPDX-License-Identifier: BSD-3-Clause
// radtan of wide lenses, where the best camera of all folds: is the fit the best of those that do not (best_radtan.h)?
#include "best_radtan.h"
#include "known_cameras.h"
#include "random_lens.h"
#include "sanitized.h"

#include <fca/convert/convert.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace fca {
namespace {

constexpr double kMostRatio = 1.005;
/// The reference stands off the fold by its barrier, and the fit by less.
constexpr double kLeastRatio = 0.9998;

bool is_long_run() { return std::getenv("FCA_ALL_RANDOM_CAMERAS") != nullptr; }

std::optional<Conversion> to_radtan(const Camera& camera, int coefficients, std::optional<double> angle_deg = {}) {
  ConvertOptions options;
  options.model = "radtan";
  options.bound = false;
  if (coefficients == 4) options.ranges = {{"k3", 0.0, 0.0}};
  if (angle_deg) options.max_angle_rad = *angle_deg * test::kRadians;
  Diagnostics diagnostics;
  return convert(camera, options, diagnostics);
}

test::Cone cone_of(const Camera& camera, const Conversion& conversion) {
  return {camera, conversion.report.scored_to_deg * test::kRadians};
}

struct NamedCamera {
  std::string name;
  Camera camera;
};

/// Lenses of more than a radtan can describe.
std::vector<NamedCamera> known_lenses() {
  const auto vga = [](const CameraModel& model) { return test::make_camera(model, {640, 480}); };
  return {{"tumvi", test::tumvi()},
          {"tumvi-ds", test::tumvi_ds()},
          {"t265-like", test::t265_like()},
          {"220-degree", test::lens_220()},
          {"ocamcalib", test::ocamcalib_sample()},
          {"woodscape", test::woodscape_front()},
          {"ucm", vga(Intrinsics<Ucm>{{300.0, 303.0, 330.0, 230.0, 0.55}})},
          {"ds-beside", vga(Intrinsics<Ds>{{175.0, 178.0, 290.0, 262.0, 0.62, -0.3}})},
          {"eucm", vga(Intrinsics<Eucm>{{240.0, 238.0, 349.0, 214.0, 0.6, 1.1}})},
          {"fov", vga(Intrinsics<Fov>{{260.0, 259.0, 315.0, 246.0, 0.93}})}};
}

std::vector<NamedCamera> lenses() {
  constexpr int kFew = 6;
  constexpr int kMany = 100;
  std::vector<NamedCamera> all = known_lenses();
  if (test::is_sanitized()) all.resize(2);
  test::Random random(27);
  for (int i = 0; i < (is_long_run() ? kMany : test::is_sanitized() ? 1 : kFew); ++i)
    all.push_back({"random " + std::to_string(i), test::wide_camera(random)});
  return all;
}

TEST(CutRadtan, IsTheBestThatDoesNotFold) {
  std::mt19937 starts(28);
  double largest = 0.0;
  int compared = 0;
  for (const NamedCamera& each : lenses()) {
    for (const int coefficients : {4, 5}) {
      SCOPED_TRACE(each.name + ", " + std::to_string(coefficients) + " coefficients");
      const std::optional<Conversion> conversion = to_radtan(each.camera, coefficients);
      ASSERT_TRUE(conversion);
      const test::Cone cone = cone_of(each.camera, *conversion);
      const double rms = cone.rms_of(conversion->camera.model);
      const double ratio = rms / test::best_radtan_rms(each.camera, cone, coefficients, starts);
      EXPECT_LE(ratio, kMostRatio) << rms << " px";
      EXPECT_GE(ratio, kLeastRatio) << rms << " px: the reference is none";
      largest = std::max(largest, ratio);
      ++compared;
      if (is_long_run()) {
        std::printf("  %-12s %d coefficients %6.2f deg %9.5f px, ratio %.4f\n", each.name.c_str(), coefficients,
                    conversion->report.scored_to_deg, rms, ratio);
      }
    }
  }
  std::printf("  %d fits compared, largest ratio %.4f\n", compared, largest);
}

// Over the cone of the fit with four coefficients: the fit with five to that cone, and the one to its own, which is no smaller.
TEST(CutRadtan, FiveCoefficientsAreNeverWorseThanFour) {
  for (const NamedCamera& each : lenses()) {
    SCOPED_TRACE(each.name);
    const std::optional<Conversion> four = to_radtan(each.camera, 4);
    ASSERT_TRUE(four);
    const std::optional<Conversion> five = to_radtan(each.camera, 5, four->report.scored_to_deg);
    const std::optional<Conversion> widest = to_radtan(each.camera, 5);
    ASSERT_TRUE(five && widest);
    const test::Cone cone = cone_of(each.camera, *four);
    const double rms = cone.rms_of(four->camera.model);
    EXPECT_LE(cone.rms_of(five->camera.model), rms);
    EXPECT_LE(cone.rms_of(widest->camera.model), rms);
    EXPECT_GE(widest->report.scored_to_deg, four->report.scored_to_deg);
  }
}

}  // namespace
}  // namespace fca
