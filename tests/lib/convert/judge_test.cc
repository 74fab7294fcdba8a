// SPDX-License-Identifier: BSD-3-Clause
#include "known_cameras.h"

#include <fca/convert/convert.h>
#include <fca/convert/judge.h>

#include <gtest/gtest.h>

#include <cmath>

namespace fca {
namespace {

/// Every pixel of the domain, as the definition says; the maximum over every half pixel.
struct BruteForce {
  double rms = 0.0;
  double max = 0.0;
  double share = 0.0;
};

BruteForce brute_force(const CameraModel& source, const CameraModel& target, const Domain& domain) {
  BruteForce result;
  double inside = 0.0;
  double all = 0.0;
  for (int j = 0; j <= 2 * (domain.size.height - 1); ++j) {
    for (int i = 0; i <= 2 * (domain.size.width - 1); ++i) {
      const bool whole_pixel = i % 2 == 0 && j % 2 == 0;
      if (whole_pixel) ++all;
      const Pixel pixel = {0.5 * i, 0.5 * j};
      const std::optional<Ray> ray = domain.ray(source, pixel);
      if (!ray) continue;
      const std::optional<Pixel> image = project(target, *ray);
      if (!image) continue;
      const double error = std::hypot((*image)[0] - pixel[0], (*image)[1] - pixel[1]);
      result.max = std::max(result.max, error);
      if (!whole_pixel) continue;
      ++inside;
      result.rms += error * error;
    }
  }
  result.rms = std::sqrt(result.rms / inside);
  result.share = inside / all;
  return result;
}

TEST(Judge, AgreesWithEveryPixel) {
  struct Case {
    Camera camera;
    std::optional<double> max_angle_deg;
    const char* target;
  };
  const std::vector<Case> cases = {{test::tumvi(), 97.5, "eucm"},   {test::tumvi(), {}, "eucm"},
                                   {test::kalibr_ds(), {}, "ucm"},  {test::euroc(), {}, "kb4"},
                                   {test::lens_220(), 110.0, "ds"}, {test::kalibr_ds(), {}, "radtan"}};
  for (const Case& c : cases) {
    ConvertOptions options;
    options.model = c.target;
    if (c.max_angle_deg) options.max_angle_rad = *c.max_angle_deg * test::kRadians;
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = convert(c.camera, options, diagnostics);
    const std::optional<Domain> domain = domain_of(c.camera, options.max_angle_rad, diagnostics);
    ASSERT_TRUE(conversion && domain);
    const Judgement& j = conversion->report.judgement;
    const BruteForce truth = brute_force(c.camera.model, conversion->camera.model, *domain);
    EXPECT_NEAR(j.error.rms, truth.rms, 0.005 * truth.rms) << c.target;
    // The true maximum lies between half pixels: never below what they show, and not above by more than the error can grow
    // there.
    EXPECT_GE(j.error.max, truth.max * (1.0 - 1e-4)) << c.target;
    EXPECT_LE(j.error.max, truth.max * 1.02) << c.target;
    EXPECT_NEAR(j.coverage.scored, truth.share, 0.003) << c.target;
    EXPECT_LE(j.error.p50, j.error.p95);
    EXPECT_LE(j.error.p95, j.error.p99);
    EXPECT_LE(j.error.p99, j.error.max);
  }
}

TEST(Judge, AConstantShiftIsMeasuredExactly) {
  const Camera camera = test::kalibr_eucm();
  Diagnostics diagnostics;
  const std::optional<Domain> domain = domain_of(camera, {}, diagnostics);
  ASSERT_TRUE(domain);
  const Projection shifted = [&camera](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> pixel = project(camera.model, ray);
    if (!pixel) return std::nullopt;
    return Pixel{(*pixel)[0] + 3.0, (*pixel)[1] - 4.0};
  };
  const Judgement j = judge(camera.model, shifted, *domain);
  for (const double value : {j.error.rms, j.error.mean, j.error.p50, j.error.p99, j.error.max}) EXPECT_NEAR(value, 5.0, 1e-9);
}

TEST(Judge, FindsASpikeAtTheEdgeOfTheLens) {
  // Error only in the last tenth of a degree, and only at one azimuth: no lattice point is there.
  const Camera camera = test::tumvi();
  Diagnostics diagnostics;
  const double limit = 80.0 * test::kRadians;
  const std::optional<Domain> domain = domain_of(camera, limit, diagnostics);
  ASSERT_TRUE(domain);
  const Projection target = [&](const Ray& ray) -> std::optional<Pixel> {
    std::optional<Pixel> pixel = project(camera.model, ray);
    const double over = angle_from_axis(ray) - (limit - 0.1 * test::kRadians);
    const double azimuth = std::atan2(ray[1], ray[0]);
    if (pixel && over > 0.0 && std::abs(azimuth - 1.0) < 0.1) (*pixel)[0] += 1000.0 * over * (0.1 - std::abs(azimuth - 1.0));
    return pixel;
  };
  const Judgement j = judge(camera.model, target, *domain);
  EXPECT_NEAR(j.error.max, 1000.0 * 0.1 * test::kRadians * 0.1, 0.005);
}

}  // namespace
}  // namespace fca
