// SPDX-License-Identifier: BSD-3-Clause
#include "known_cameras.h"

#include <fca/convert/sample.h>

#include <gtest/gtest.h>

#include <cmath>

namespace fca {
namespace {

/// Mean of f over the domain's area, by every half pixel; points on the image's border stand for half a cell.
template <class F>
double mean_over_area(const CameraModel& source, const Domain& domain, F&& f) {
  double sum = 0.0;
  double count = 0.0;
  const int last_row = 2 * (domain.size.height - 1);
  const int last_column = 2 * (domain.size.width - 1);
  for (int j = 0; j <= last_row; ++j) {
    for (int i = 0; i <= last_column; ++i) {
      const double weight = (j == 0 || j == last_row ? 0.5 : 1.0) * (i == 0 || i == last_column ? 0.5 : 1.0);
      const Pixel pixel = {0.5 * i, 0.5 * j};
      const std::optional<Ray> ray = domain.ray(source, pixel);
      if (!ray) continue;
      sum += weight * f(pixel, *ray);
      count += weight;
    }
  }
  return sum / count;
}

TEST(Sample, WeightedSumsAreMeansOverTheDomain) {
  struct Case {
    Camera camera;
    std::optional<double> max_angle_deg;
  };
  for (const Case& c :
       {Case{test::kalibr_ds(), {}}, Case{test::tumvi(), 97.5}, Case{test::lens_220(), 110.0}, Case{test::t265_like(), 83.0}}) {
    Diagnostics diagnostics;
    std::optional<double> limit;
    if (c.max_angle_deg) limit = *c.max_angle_deg * test::kRadians;
    const std::optional<Domain> domain = domain_of(c.camera, limit, diagnostics);
    ASSERT_TRUE(domain);
    const std::vector<Correspondence> samples = sample(c.camera.model, *domain, 200);
    EXPECT_GE(samples.size(), 150u);
    EXPECT_LE(samples.size(), 450u);
    double total = 0.0;
    for (const Correspondence& s : samples) total += s.weight;
    EXPECT_NEAR(total, 1.0, 1e-12);
    // Like the squared residual of a fit: smooth, and largest at the rim.
    const auto rim_heavy = [](const Pixel& pixel, const Ray& ray) {
      return std::pow(angle_from_axis(ray), 8) * (1.0 + 1e-3 * pixel[0]);
    };
    double by_samples = 0.0;
    for (const Correspondence& s : samples) by_samples += s.weight * rim_heavy(s.pixel, s.ray);
    const double by_area = mean_over_area(c.camera.model, *domain, rim_heavy);
    EXPECT_NEAR(by_samples, by_area, 0.01 * by_area);
  }
}

TEST(Sample, RaysAreThoseOfThePixels) {
  Diagnostics diagnostics;
  const Camera camera = test::lens_220();
  const std::optional<Domain> domain = domain_of(camera, 110.0 * test::kRadians, diagnostics);
  ASSERT_TRUE(domain);
  bool behind = false;
  for (const Correspondence& s : sample(camera.model, *domain)) {
    const std::optional<Pixel> pixel = project(camera.model, s.ray);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR((*pixel)[0], s.pixel[0], 1e-9);
    EXPECT_NEAR((*pixel)[1], s.pixel[1], 1e-9);
    EXPECT_LE(angle_from_axis(s.ray), domain->max_angle_rad);
    behind = behind || s.ray[2] < 0.0;
  }
  EXPECT_TRUE(behind);
}

}  // namespace
}  // namespace fca
