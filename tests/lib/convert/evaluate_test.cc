// SPDX-License-Identifier: BSD-3-Clause
#include "known_cameras.h"

#include <convert/evaluation/lattice.h>
#include <fca/convert/convert.h>
#include <fca/convert/evaluate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca {
namespace {

/// Every pixel of the field of view, as the definition says; the maximum over every half pixel.
struct BruteForce {
  double rms = 0.0;
  double max = 0.0;
  double share = 0.0;
};

BruteForce brute_force(const CameraModel& source, const CameraModel& target, const FieldOfView& field_of_view) {
  BruteForce result;
  double inside = 0.0;
  double all = 0.0;
  for (int j = 0; j <= 2 * (field_of_view.size.height - 1); ++j) {
    for (int i = 0; i <= 2 * (field_of_view.size.width - 1); ++i) {
      const bool whole_pixel = i % 2 == 0 && j % 2 == 0;
      if (whole_pixel) ++all;
      const Pixel pixel = {0.5 * i, 0.5 * j};
      const std::optional<Ray> ray = field_of_view.ray(source, pixel);
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

TEST(Evaluate, AgreesWithEveryPixel) {
  struct Case {
    Camera camera;
    std::optional<double> max_angle_deg;
    const char* target;
  };
  const std::vector<Case> cases = {{test::tumvi(), 97.5, "eucm"},
                                   {test::tumvi(), {}, "eucm"},
                                   {test::kalibr_ds(), {}, "ucm"},
                                   {test::euroc(), {}, "kb4"},
                                   {test::lens_220(), 110.0, "ds"},
                                   {test::kalibr_ds(), {}, "radtan"},
                                   // circles inside the image, cut by its border, and with a cone that cuts both
                                   {test::with_image_circle(test::tumvi(), {230.0, 275.0}, 215.0), {}, "eucm"},
                                   {test::with_image_circle(test::kalibr_ds(), {420.0, 200.0}, 300.0), {}, "kb4"},
                                   {test::with_image_circle(test::tumvi(), {200.0, 260.0}, 220.0), 80.0, "ucm"}};
  for (const Case& c : cases) {
    ConvertOptions options;
    options.model = c.target;
    if (c.max_angle_deg) options.max_angle_rad = *c.max_angle_deg * test::kRadians;
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = convert(c.camera, options, diagnostics);
    const std::optional<FieldOfView> field_of_view = field_of_view_of(c.camera, options.max_angle_rad, diagnostics);
    ASSERT_TRUE(conversion && field_of_view);
    const ErrorStatistics& j = conversion->report.statistics;
    const BruteForce truth = brute_force(c.camera.model, conversion->camera.model, *field_of_view);
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

/// The cameras of the table with the angles at which their lenses end, and targets that reach these.
struct TablePair {
  Camera camera;
  std::optional<double> max_angle_deg;
  std::vector<const char*> targets;
};

std::vector<TablePair> table() {
  using namespace test;
  const std::vector<const char*> wide = {"ucm", "eucm", "ds", "kb4", "ocamcalib", "mei"};
  const std::vector<const char*> all = {"ucm", "eucm", "ds", "kb4", "ocamcalib", "mei", "radtan", "rational"};
  std::vector<TablePair> pairs = {
      {kalibr_ds(), {}, all},
      {kalibr_eucm(), {}, all},
      {kalibr_kb4(), {}, all},
      {euroc(), {}, all},
      {rational_lens(), {}, all},
      // up to its corners, where errors are many times those next to them
      {make_camera(Intrinsics<Kb4>{{280, 280, 322, 237, -0.03, 0.07, -0.06, 0.018}}, {640, 480}), {}, all}};
  const std::vector<std::pair<Camera, double>> lenses = {
      {tumvi(), 97.5}, {t265_like(), 83.0}, {ocamcalib_sample(), 95.0}, {woodscape_front(), 95.0}, {lens_220(), 110.0}};
  for (const auto& [camera, degrees] : lenses) {
    pairs.push_back({camera, degrees, wide});
    pairs.push_back({camera, 60.0, {"radtan"}});
    pairs.push_back({camera, 80.0, {"rational"}});
  }
  return pairs;
}

struct Source {
  Camera camera;
  std::optional<double> max_angle_deg;
};

/// Bands of which there are too few pixels say nothing.
void expect_same_bands(const ErrorStatistics& lattice, const ErrorStatistics& pixels) {
  constexpr double kFewPixels = 0.003;
  for (std::size_t i = 0; i < pixels.bands.size(); ++i) {
    const ErrorBand& band = pixels.bands[i];
    if (band.share < kFewPixels) continue;
    ASSERT_LT(i, lattice.bands.size());
    EXPECT_NEAR(lattice.bands[i].share, band.share, 0.02 * band.share) << band.from_deg << " degrees";
    EXPECT_NEAR(lattice.bands[i].rms_px, band.rms_px, 0.03 * band.rms_px) << band.from_deg << " degrees";
  }
}

TEST(Evaluate, TheLatticeStandsForEveryPixel) {
  for (const TablePair& pair : table()) {
    for (const char* target : pair.targets) {
      SCOPED_TRACE(std::string(model_info(pair.camera.model).id) + " -> " + target);
      ConvertOptions options;
      options.model = target;
      options.bound = false;
      if (pair.max_angle_deg) options.max_angle_rad = *pair.max_angle_deg * test::kRadians;
      Diagnostics diagnostics;
      const std::optional<Conversion> conversion = convert(pair.camera, options, diagnostics);
      const std::optional<FieldOfView> field_of_view = field_of_view_of(pair.camera, options.max_angle_rad, diagnostics);
      ASSERT_TRUE(conversion && field_of_view);
      const ErrorStatistics& lattice = conversion->report.statistics;
      EvaluateOptions every_pixel;
      every_pixel.every_pixel = true;
      every_pixel.bound = false;
      const ErrorStatistics pixels = evaluate(pair.camera.model, conversion->camera.model, *field_of_view, every_pixel);
      constexpr double kRounding = 1e-9;  // px: radtan -> mei with xi = 0, and the exact pairs
      if (lattice.error.max <= kRounding) {
        EXPECT_LE(pixels.error.max, kRounding);
        continue;
      }
      EXPECT_NEAR(lattice.error.rms, pixels.error.rms, 0.003 * pixels.error.rms);
      EXPECT_NEAR(lattice.error.mean, pixels.error.mean, 0.01 * pixels.error.mean);
      EXPECT_NEAR(lattice.error.p95, pixels.error.p95, 0.05 * pixels.error.p95);
      EXPECT_NEAR(lattice.error.max, pixels.error.max, 1e-3 * pixels.error.max);
      EXPECT_NEAR(lattice.coverage.scored, pixels.coverage.scored, 0.002);
      expect_same_bands(lattice, pixels);
    }
  }
}

/// The largest error at an angle from the axis, within the image, by small steps around it.
double worst_on_rim(const Camera& camera, const CameraModel& target, double angle) {
  constexpr int kSteps = 20'000;
  double worst = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double azimuth = 2.0 * std::numbers::pi * i / kSteps;
    const Ray ray = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
    const std::optional<Pixel> meant = project(camera.model, ray);
    const std::optional<Pixel> given = project(target, ray);
    if (!meant || !given || !camera.image_size->holds(*meant)) continue;
    worst = std::max(worst, std::hypot((*given)[0] - (*meant)[0], (*given)[1] - (*meant)[1]));
  }
  return worst;
}

// Errors are often largest where a lens or a cone ends inside the image, between pixels and between the lattice's points.
TEST(Evaluate, TheMaximumIsFoundOnTheEdgeOfTheLens) {
  constexpr double kHair = 2e-7;  // where a lens folds, a pixel tells the angle no better
  int largest_on_rim = 0;
  const Camera cameras[] = {test::euroc(), test::tumvi(), test::kalibr_ds(), test::kalibr_radtan(),
                            // two whose radius ends inside the image
                            test::make_camera(Intrinsics<Ds>{{300, 300, 320, 240, 1.0, -0.4}}, {640, 480}),
                            test::make_camera(Intrinsics<Ucm>{{200, 201, 310, 250, 1.0}}, {640, 480})};
  for (const Camera& camera : cameras) {
    for (const double degrees : {20.0, 45.0, 70.0, 95.0, 180.0}) {
      for (const char* target : {"ucm", "ds", "mei", "fov", "ocamcalib", "woodscape", "rational"}) {
        SCOPED_TRACE(std::string(model_info(camera.model).id) + " -> " + target + " within " + std::to_string(degrees));
        ConvertOptions options;
        options.model = target;
        options.max_angle_rad = degrees * test::kRadians;
        Diagnostics diagnostics;
        const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
        if (!conversion || conversion->report.exact) continue;
        const double edge = conversion->report.scored_to_deg * test::kRadians * (1.0 - kHair);
        const double rim = worst_on_rim(camera, conversion->camera.model, edge);
        const double found = conversion->report.statistics.error.max;
        constexpr double kSteepness = 1e-6;  // of the error along the angle, times the hair; and of the steps
        EXPECT_GE(found, rim * (1.0 - kSteepness) - 1e-9);
        largest_on_rim += rim > 0.999 * found ? 1 : 0;
      }
    }
  }
  EXPECT_GT(largest_on_rim, 20);
}

// A corner may lie in a band of its own, with none of the lattice's points in it.
TEST(Evaluate, ABandHoldsTheMaximum) {
  std::vector<Source> sources = {
      {test::make_camera(Intrinsics<Ds>{{99.342, 99.595, 144.53, 98.41, 0.74955, -0.16405}}, {320, 240}), {}}};
  for (const TablePair& pair : table()) sources.push_back({pair.camera, pair.max_angle_deg});
  for (const Source& source : sources) {
    for (const char* target : {"ucm", "kb4", "mei"}) {
      ConvertOptions options;
      options.model = target;
      if (source.max_angle_deg) options.max_angle_rad = *source.max_angle_deg * test::kRadians;
      Diagnostics diagnostics;
      const std::optional<Conversion> conversion = convert(source.camera, options, diagnostics);
      ASSERT_TRUE(conversion);
      const ErrorStatistics& j = conversion->report.statistics;
      double worst = 0.0;
      for (const ErrorBand& band : j.bands) {
        worst = std::max(worst, band.max_px);
        EXPECT_LE(band.rms_px, band.max_px * (1.0 + 1e-12));
      }
      EXPECT_EQ(worst, j.error.max) << model_info(source.camera.model).id << " -> " << target;
    }
  }
}

// The image of this lens is next to right but for a corner, which a lattice of 5,000 points hardly sees.
TEST(Evaluate, ErrorsOfACornerAreSummedOverItsPixels) {
  const Camera camera = test::make_camera(Intrinsics<Kb4>{{300.0, 300.0, -400.0, 900.0, 0.01, 0.0, 0.0, 0.0}}, {640, 480});
  ConvertOptions options;
  options.model = "ds";
  options.bound = false;
  Diagnostics diagnostics;
  const std::optional<Conversion> lattice = convert(camera, options, diagnostics);
  options.every_pixel = true;
  const std::optional<Conversion> pixels = convert(camera, options, diagnostics);
  ASSERT_TRUE(lattice && pixels);
  const double rms = pixels->report.statistics.error.rms;
  EXPECT_GT(pixels->report.statistics.error.max, 50.0 * rms);
  EXPECT_NEAR(lattice->report.statistics.error.rms, rms, 0.01 * rms);
  EXPECT_EQ(lattice->report.statistics.coverage.scored_pixels, 0);
}

// CLI.md promises them, whatever the lens, and however small a part of it is scored.
TEST(Evaluate, TheLatticeHasFourThousandScoredPoints) {
  constexpr double kMaxAnglesRad[] = {1e-3, 0.05, 0.3, 1.0, std::numbers::pi};
  for (const TablePair& pair : table()) {
    std::optional<double> limit;
    if (pair.max_angle_deg) limit = *pair.max_angle_deg * test::kRadians;
    Diagnostics diagnostics;
    const std::optional<FieldOfView> field_of_view = field_of_view_of(pair.camera, limit, diagnostics);
    ASSERT_TRUE(field_of_view);
    for (const double max_angle_rad : kMaxAnglesRad) {
      const internal::Scorer scorer(pair.camera.model, &pair.camera.model, nullptr, *field_of_view, max_angle_rad);
      const std::vector<internal::Point> points = internal::score_lattice(scorer);
      const auto scored = std::ranges::count(points, internal::Verdict::kScored, &internal::Point::verdict);
      EXPECT_GE(scored, 4000) << points.size() << " points, " << model_info(pair.camera.model).id << " within "
                              << max_angle_rad;
    }
  }
}

TEST(Evaluate, CountsEveryPixel) {
  const Camera camera = test::tumvi();
  ConvertOptions options;
  options.model = "radtan";  // reaches only a part of the lens
  options.max_angle_rad = 97.5 * test::kRadians;
  options.every_pixel = true;
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, options.max_angle_rad, diagnostics);
  ASSERT_TRUE(conversion && field_of_view);
  const Coverage& coverage = conversion->report.statistics.coverage;
  long long outside = 0;
  for (int y = 0; y < field_of_view->size.height; ++y) {
    for (int x = 0; x < field_of_view->size.width; ++x)
      outside += !field_of_view->ray(camera.model, {static_cast<double>(x), static_cast<double>(y)});
  }
  const long long pixels = 1LL * field_of_view->size.width * field_of_view->size.height;
  EXPECT_EQ(coverage.outside_lens_pixels, outside);
  EXPECT_GT(coverage.scored_pixels, 0);
  EXPECT_GT(coverage.unrepresentable_pixels, 0);
  EXPECT_EQ(coverage.scored_pixels + coverage.outside_lens_pixels + coverage.unrepresentable_pixels, pixels);
  EXPECT_NEAR(coverage.scored, static_cast<double>(coverage.scored_pixels) / static_cast<double>(pixels), 1e-12);

  // The percentile of all pixels' errors, to the width of a bin.
  std::vector<double> errors;
  for (int y = 0; y < field_of_view->size.height; ++y) {
    for (int x = 0; x < field_of_view->size.width; ++x) {
      const Pixel pixel = {static_cast<double>(x), static_cast<double>(y)};
      const std::optional<Ray> ray = field_of_view->ray(camera.model, pixel);
      const std::optional<Pixel> image = ray ? project(conversion->camera.model, *ray) : std::nullopt;
      if (image) errors.push_back(std::hypot((*image)[0] - pixel[0], (*image)[1] - pixel[1]));
    }
  }
  std::ranges::sort(errors);
  // The report counts no pixel beyond the cone of the fit; this model goes on a little further.
  if (static_cast<long long>(errors.size()) == coverage.scored_pixels) {
    const double p95 = errors[static_cast<std::size_t>(0.95 * static_cast<double>(errors.size()))];
    EXPECT_NEAR(conversion->report.statistics.error.p95, p95, 2e-3 * p95);
  }
}

// The worst place of a round field of view lies on its edge, between pixels.
TEST(Evaluate, EveryPixelFindsNoSmallerMaximumThanTheLattice) {
  for (const Camera& camera : {test::lens_220(), test::tumvi()}) {
    for (const char* target : {"rational", "eucm", "ds"}) {
      const auto largest = [&](bool every_pixel) {
        ConvertOptions options;
        options.model = target;
        options.max_angle_rad = 97.5 * test::kRadians;
        options.every_pixel = every_pixel;
        Diagnostics diagnostics;
        const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
        EXPECT_TRUE(conversion) << target;
        return conversion ? conversion->report.statistics.error.max : 0.0;
      };
      const double on_lattice = largest(false);
      EXPECT_GE(largest(true), on_lattice * (1.0 - 1e-9)) << target;
    }
  }
}

// A cone between the points of the lattice in which the field of view is first looked for.
TEST(Evaluate, AFewDegreesAreAFieldOfView) {
  Camera camera = test::tumvi();
  ASSERT_TRUE(set_parameter(camera.model, "cx", 250.2));
  ASSERT_TRUE(set_parameter(camera.model, "cy", 250.2));
  Diagnostics diagnostics;
  constexpr double kAngle = 1.2 * test::kRadians;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, kAngle, diagnostics);
  ASSERT_TRUE(field_of_view);
  EXPECT_EQ(field_of_view->max_angle_rad, kAngle);
}

TEST(Evaluate, SharesAddUpToOne) {
  for (const TablePair& pair : table()) {
    for (const char* target : {"pinhole", "radtan", "rational", "ucm", "kb4", "ocamcalib", "fov", "woodscape"}) {
      for (const bool every_pixel : {false, true}) {
        ConvertOptions options;
        options.model = target;
        options.bound = false;
        options.every_pixel = every_pixel;
        if (pair.max_angle_deg) options.max_angle_rad = *pair.max_angle_deg * test::kRadians;
        Camera camera = pair.camera;
        if (every_pixel) camera.image_size = ImageSize{301, 203};
        Diagnostics diagnostics;
        const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
        if (!conversion) continue;
        const Coverage& c = conversion->report.statistics.coverage;
        EXPECT_NEAR(c.scored + c.outside_lens + c.unrepresentable, 1.0, 1e-12) << target;
      }
    }
  }
}

TEST(Evaluate, AConstantShiftIsMeasuredExactly) {
  const Camera camera = test::kalibr_eucm();
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  const Projection shifted = [&camera](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> pixel = project(camera.model, ray);
    if (!pixel) return std::nullopt;
    return Pixel{(*pixel)[0] + 3.0, (*pixel)[1] - 4.0};
  };
  const ErrorStatistics j = evaluate(camera.model, shifted, *field_of_view);
  for (const double value : {j.error.rms, j.error.mean, j.error.p50, j.error.p99, j.error.max}) EXPECT_NEAR(value, 5.0, 1e-9);
}

TEST(Evaluate, FindsASpikeAtTheEdgeOfTheLens) {
  // Error only in the last tenth of a degree, and only at one azimuth: no lattice point is there.
  const Camera camera = test::tumvi();
  Diagnostics diagnostics;
  const double limit = 80.0 * test::kRadians;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, limit, diagnostics);
  ASSERT_TRUE(field_of_view);
  const Projection target = [&](const Ray& ray) -> std::optional<Pixel> {
    std::optional<Pixel> pixel = project(camera.model, ray);
    const double over = angle_from_axis(ray) - (limit - 0.1 * test::kRadians);
    const double azimuth = std::atan2(ray[1], ray[0]);
    if (pixel && over > 0.0 && std::abs(azimuth - 1.0) < 0.1) (*pixel)[0] += 1000.0 * over * (0.1 - std::abs(azimuth - 1.0));
    return pixel;
  };
  const ErrorStatistics j = evaluate(camera.model, target, *field_of_view);
  EXPECT_NEAR(j.error.max, 1000.0 * 0.1 * test::kRadians * 0.1, 0.005);
}

}  // namespace
}  // namespace fca
