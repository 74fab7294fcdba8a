// SPDX-License-Identifier: BSD-3-Clause
#include "known_cameras.h"

#include <fca/convert/sample.h>

#include <gtest/gtest.h>

#include <cmath>

namespace fca {
namespace {

/// Mean of f over the field of view's pixels.
template <class F>
double mean_over_pixels(const CameraModel& source, const FieldOfView& field_of_view, F&& f) {
  double sum = 0.0;
  double count = 0.0;
  for (int y = 0; y < field_of_view.size.height; ++y) {
    for (int x = 0; x < field_of_view.size.width; ++x) {
      const Pixel pixel = {static_cast<double>(x), static_cast<double>(y)};
      const std::optional<Ray> ray = field_of_view.ray(source, pixel);
      if (!ray) continue;
      sum += f(pixel, *ray);
      count += 1.0;
    }
  }
  return sum / count;
}

TEST(Sample, WeightedSumsAreMeansOverTheFieldOfView) {
  struct Case {
    Camera camera;
    std::optional<double> max_angle_deg;
  };
  for (const Case& c :
       {Case{test::kalibr_ds(), {}}, Case{test::tumvi(), 97.5}, Case{test::lens_220(), 110.0}, Case{test::t265_like(), 83.0}}) {
    Diagnostics diagnostics;
    std::optional<double> limit;
    if (c.max_angle_deg) limit = *c.max_angle_deg * test::kRadians;
    const std::optional<FieldOfView> field_of_view = field_of_view_of(c.camera, limit, diagnostics);
    ASSERT_TRUE(field_of_view);
    const std::vector<Correspondence> samples = sample(c.camera.model, *field_of_view, 200);
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
    const double by_pixels = mean_over_pixels(c.camera.model, *field_of_view, rim_heavy);
    EXPECT_NEAR(by_samples, by_pixels, 0.01 * by_pixels);
  }
}

// The error of a model that bends fast is largest in the last pixels of the image's corners, which a mean over the area between
// the pixels would count by a quarter.
TEST(Sample, CornerPixelsCountAsWholePixels) {
  Diagnostics diagnostics;
  const Camera camera = test::kalibr_ds();
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  const auto corner_heavy = [&](const Pixel& pixel, const Ray& /*ray*/) {
    const double u = 2.0 * pixel[0] / (field_of_view->size.width - 1.0) - 1.0;
    const double v = 2.0 * pixel[1] / (field_of_view->size.height - 1.0) - 1.0;
    return std::pow(u * v, 24);
  };
  double by_samples = 0.0;
  for (const Correspondence& s : sample(camera.model, *field_of_view, 400))
    by_samples += s.weight * corner_heavy(s.pixel, s.ray);
  const double by_pixels = mean_over_pixels(camera.model, *field_of_view, corner_heavy);
  EXPECT_NEAR(by_samples, by_pixels, 1e-9 * by_pixels);
}

// Where the source's radius stops growing with the angle, degrees lie in the last tenth of a pixel.
TEST(Sample, TheEdgeOfALensThatEndsIsSeen) {
  Diagnostics diagnostics;
  const Camera camera = test::make_camera(
      Intrinsics<Ds>{{133.5677629, 135.2386744, 342.1421672, 264.3405367, 0.7025675221, -0.5568606152}}, {640, 480});
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  // The squared residual of a model that fails in the last two degrees.
  const auto edge_heavy = [&](const Pixel& /*pixel*/, const Ray& ray) {
    return std::exp(angle_from_axis(ray) / test::kRadians - 84.0);
  };
  double by_samples = 0.0;
  for (const Correspondence& s : sample(camera.model, *field_of_view)) by_samples += s.weight * edge_heavy(s.pixel, s.ray);
  const double by_pixels = mean_over_pixels(camera.model, *field_of_view, edge_heavy);
  // Which pixels' centres lie in that tenth is chance.
  EXPECT_NEAR(by_samples, by_pixels, 0.05 * by_pixels);
}

TEST(Sample, NoMorePlacesThanPixels) {
  for (const ImageSize size : {ImageSize{1, 1}, ImageSize{2, 1}, ImageSize{3, 2}}) {
    Diagnostics diagnostics;
    const Camera camera = test::make_camera(Intrinsics<Pinhole>{{100.0, 100.0, 0.0, 0.0}}, size);
    const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
    ASSERT_TRUE(field_of_view);
    const std::vector<Correspondence> samples = sample(camera.model, *field_of_view);
    ASSERT_EQ(samples.size(), static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    for (const Correspondence& s : samples) {
      for (const double coordinate : s.pixel) EXPECT_NEAR(coordinate, std::round(coordinate), 1e-12);
      EXPECT_NEAR(s.weight, 1.0 / static_cast<double>(samples.size()), 1e-12);
    }
  }
}

TEST(Sample, RaysAreThoseOfThePixels) {
  Diagnostics diagnostics;
  const Camera camera = test::lens_220();
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, 110.0 * test::kRadians, diagnostics);
  ASSERT_TRUE(field_of_view);
  bool behind = false;
  for (const Correspondence& s : sample(camera.model, *field_of_view)) {
    const std::optional<Pixel> pixel = project(camera.model, s.ray);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR((*pixel)[0], s.pixel[0], 1e-9);
    EXPECT_NEAR((*pixel)[1], s.pixel[1], 1e-9);
    EXPECT_LE(angle_from_axis(s.ray), field_of_view->max_angle_rad);
    behind = behind || s.ray[2] < 0.0;
  }
  EXPECT_TRUE(behind);
}

}  // namespace
}  // namespace fca
