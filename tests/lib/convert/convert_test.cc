// SPDX-License-Identifier: BSD-3-Clause
#include "known_cameras.h"

#include <fca/code.h>
#include <fca/convert/convert.h>
#include <fca/convert/evaluate.h>
#include <fca/convert/field_of_view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <variant>

namespace fca {
namespace {

std::optional<Conversion> to(const Camera& camera, const std::string& model, Diagnostics& diagnostics,
                             std::optional<double> deg = {}) {
  ConvertOptions options;
  options.model = model;
  if (deg) options.max_angle_rad = *deg * test::kRadians;
  return convert(camera, options, diagnostics);
}

std::optional<Conversion> to(const Camera& camera, const std::string& model) {
  Diagnostics diagnostics;
  return to(camera, model, diagnostics);
}

TEST(Convert, TheSameModelIsACopy) {
  const std::optional<Conversion> conversion = to(test::tumvi(), "kb4");
  ASSERT_TRUE(conversion);
  EXPECT_TRUE(conversion->report.exact);
  EXPECT_EQ(conversion->camera, test::tumvi());
  EXPECT_LE(conversion->report.statistics.error.max, 1e-9);
}

TEST(Convert, ContainedModelsAreExact) {
  struct Pair {
    CameraModel source;
    const char* target;
  };
  const std::vector<Pair> pairs = {
      {Intrinsics<Ucm>{{300, 301, 320, 240, 0.6}}, "eucm"},
      {Intrinsics<Ucm>{{300, 301, 320, 240, 0.6}}, "ds"},
      {Intrinsics<Ucm>{{300, 301, 320, 240, 0.6}}, "mei"},
      {Intrinsics<Mei>{{700, 705, 320, 240, 1.4, 0, 0, 0, 0}}, "ucm"},
      {Intrinsics<Eucm>{{300, 301, 320, 240, 0.6, 1.0}}, "mei"},
      {Intrinsics<Pinhole>{{400, 401, 320, 240}}, "radtan"},
      {Intrinsics<Pinhole>{{400, 401, 320, 240}}, "eucm"},
      {Intrinsics<Radtan>{{400, 401, 320, 240, 0, 0, 0, 0, 0}}, "pinhole"},
      {Intrinsics<Radtan>{{400, 401, 320, 240, -0.2, 0.05, 1e-3, -2e-3, 0.01}}, "rational"},
      {Intrinsics<Rational>{{400, 401, 320, 240, -0.2, 0.05, 1e-3, -2e-3, 0.01, 0, 0, 0}}, "radtan"},
      {Intrinsics<Pinhole>{{400, 401, 320, 240}}, "rational"},
      {Intrinsics<Rational>{{400, 401, 320, 240, 0, 0, 0, 0, 0, 0, 0, 0}}, "ucm"},
      {Intrinsics<Pinhole>{{400, 401, 320, 240}}, "mei"},
      {Intrinsics<Radtan>{{400, 401, 320, 240, -0.2, 0.05, 1e-3, -2e-3, 0}}, "mei"},
      {Intrinsics<Rational>{{400, 401, 320, 240, -0.2, 0.05, 1e-3, -2e-3, 0, 0, 0, 0}}, "mei"},
      {Intrinsics<Mei>{{400, 401, 320, 240, 0, -0.2, 0.05, 1e-3, -2e-3}}, "radtan"},
      {Intrinsics<Mei>{{400, 401, 320, 240, 0, -0.2, 0.05, 1e-3, -2e-3}}, "rational"},
      {Intrinsics<Mei>{{400, 401, 320, 240, 0, 0, 0, 0, 0}}, "pinhole"},
      {Intrinsics<Ds>{{300, 301, 320, 240, 0.0, 0.4}}, "ucm"},
      {Intrinsics<Ds>{{300, 301, 320, 240, 0.0, 0.9}}, "eucm"},
      {Intrinsics<Ds>{{300, 301, 320, 240, 0.0, 0.4}}, "mei"},
      {Intrinsics<Ds>{{300, 301, 320, 240, 0.6, 0.0}}, "ucm"},
      {Intrinsics<Ds>{{300, 301, 320, 240, 0.6, 0.0}}, "eucm"},
      {Intrinsics<Ds>{{300, 301, 320, 240, 0.6, 0.0}}, "mei"},
      {Intrinsics<Eucm>{{400, 401, 320, 240, 0.0, 1.7}}, "pinhole"},
      {Intrinsics<Eucm>{{400, 401, 320, 240, 0.0, 0.3}}, "radtan"},
      {Intrinsics<Ucm>{{200, 201, 320, 240, 0.5}}, "ocamcalib"},
      {Intrinsics<Ds>{{200, 201, 320, 240, 0.5, 0.0}}, "ocamcalib"},
      {Intrinsics<Kb4>{{200, 201, 320, 240, -0.02, 0, 0, 0}}, "woodscape"},
      {Intrinsics<Kb4>{{200, 201, 320, 240, 0.01, 0, 0, 0}}, "woodscape"},
      {Intrinsics<Woodscape>{{200, 0, -5, 0, 1.01, 320, 240}}, "kb4"},
      {Intrinsics<Kb4>{{200, 201, 320, 240, 0, 0, 0, 0}}, "fov"},
      {Intrinsics<Woodscape>{{200, 0, 0, 0, 1.01, 320, 240}}, "fov"},
      {Intrinsics<Fov>{{200, 201, 320, 240, 2.0 * std::atan(0.5)}}, "kb4"},
      {Intrinsics<Fov>{{200, 201, 320, 240, 2.0 * std::atan(0.5)}}, "woodscape"},
      {Intrinsics<Pinhole>{{400, 401, 320, 240}}, "ocamcalib"},
      {Intrinsics<Ocamcalib>{{320, 240, 1.0025, 0, 0, -400, 0, 0, 0, 0, 0, 0, 0, 0}}, "pinhole"},
      {Intrinsics<Ocamcalib>{{320, 240, 1.0025, 0, 0, -400, 0, 0, 0, 0, 0, 0, 0, 0}}, "eucm"},
  };
  for (const Pair& pair : pairs) {
    const std::optional<Conversion> conversion = to(test::make_camera(pair.source, {640, 480}), pair.target);
    ASSERT_TRUE(conversion) << pair.target;
    EXPECT_TRUE(conversion->report.exact) << pair.target;
    EXPECT_LE(conversion->report.statistics.error.max, 1e-9) << pair.target;
    EXPECT_NEAR(conversion->report.statistics.coverage.scored, 1.0, 1e-12) << pair.target;
  }
}

// A parabola mirror is the limit xi -> infinity of mei. A bounded xi is as good as a program can compute with.
TEST(Convert, MeiComesAsCloseToAParabolaMirrorAsProgramsCan) {
  for (const CameraModel& source : std::vector<CameraModel>{Intrinsics<Ucm>{{460.9, 459.6, 365.8, 248.9, 1.0}},
                                                            Intrinsics<Eucm>{{230.9, 229.6, 365.8, 248.9, 1.0, 1.0}},
                                                            Intrinsics<Ds>{{460.9, 459.6, 365.8, 248.9, 1.0, 0.0}},
                                                            Intrinsics<Ucm>{{460.9, 459.6, 365.8, 248.9, 1.0 - 1e-12}}}) {
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = to(test::make_camera(source, {752, 480}), "mei", diagnostics);
    ASSERT_TRUE(conversion);
    EXPECT_TRUE(diagnostics.entries().empty());
    EXPECT_LE(conversion->report.statistics.error.max, 5e-6);
    EXPECT_EQ(conversion->report.statistics.coverage.unrepresentable, 0.0);
    const CameraModel& model = conversion->camera.model;
    EXPECT_LE(std::get<Intrinsics<Mei>>(model).values[4], 1e8);
    EXPECT_EQ(conversion->report.at_bound, std::vector<std::string>{"xi"});
    // Its own way back from the pixel.
    for (const Pixel& pixel : {Pixel{200.0, 150.0}, Pixel{365.8, 248.9}, Pixel{500.0, 300.0}}) {
      const std::optional<Ray> ray = unproject(model, pixel);
      ASSERT_TRUE(ray);
      const std::optional<Pixel> back = project(source, *ray);
      ASSERT_TRUE(back);
      EXPECT_NEAR((*back)[0], pixel[0], 5e-6);
      EXPECT_NEAR((*back)[1], pixel[1], 5e-6);
    }
  }
}

TEST(Convert, RaysBehindTheCameraAreFittedAndScored) {
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = to(test::lens_220(), "ds", diagnostics, 110.0);
  ASSERT_TRUE(conversion);
  const std::vector<ErrorBand>& bands = conversion->report.statistics.bands;
  ASSERT_EQ(bands.size(), 11u);
  EXPECT_GT(bands[9].share, 0.1);
  EXPECT_GT(bands[10].share, 0.1);
  EXPECT_LT(bands[10].max_px, 1.0);
}

TEST(Convert, SharesAddUpToTheImage) {
  for (const char* target : {"eucm", "radtan", "kb4"}) {
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = to(test::tumvi(), target, diagnostics, 97.5);
    ASSERT_TRUE(conversion);
    const ErrorStatistics& j = conversion->report.statistics;
    EXPECT_NEAR(j.coverage.scored + j.coverage.outside_lens + j.coverage.unrepresentable, 1.0, 1e-12) << target;
    double bands = 0.0;
    for (const ErrorBand& band : j.bands) bands += band.share;
    EXPECT_NEAR(bands, j.coverage.scored, 1e-12) << target;
  }
}

// The free optimum of these folds before the lens's edge. A fit that does not fold is there, by least squares with that
// condition on the radial profile (numpy): 0.137 px, and 0.66 and 0.82 px inside 66 and 67 deg of TUM-VI's.
TEST(Convert, RadtanIsHeldFromFoldingNoMoreThanItMust) {
  struct Case {
    Camera camera;
    std::optional<double> max_angle_deg;
    double rms_px;
  };
  const Camera held = test::make_camera(Intrinsics<Kb4>{{300.0, 300.0, 376.0, 240.0, 0.0, 0.0, 0.0, -0.3}}, {752, 480});
  for (const Case& c : {Case{held, {}, 0.137}, Case{test::tumvi(), 66.0, 0.66}, Case{test::tumvi(), 67.0, 0.82}}) {
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = to(c.camera, "radtan", diagnostics, c.max_angle_deg);
    ASSERT_TRUE(conversion);
    EXPECT_TRUE(diagnostics.entries().empty());
    EXPECT_EQ(conversion->report.statistics.coverage.unrepresentable, 0.0);
    EXPECT_LE(conversion->report.statistics.error.rms, 1.04 * c.rms_px);
  }
}

// Whatever the angle, up to the whole degree at which the rms passes 1 px.
TEST(Convert, RadtansAngleIsTheLargest) {
  const Camera camera = test::make_camera(Intrinsics<Kb4>{{250.0, 250.0, 376.0, 240.0, 0.0, 0.0, 0.0, 0.0}}, {752, 480});
  for (const double degrees : {64.0, 64.25, 64.5, 64.75, 65.0, 65.25, 66.0}) {
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = to(camera, "radtan", diagnostics, degrees);
    ASSERT_TRUE(conversion);
    EXPECT_FALSE(conversion->report.angle_reduced) << degrees;
    EXPECT_EQ(conversion->report.statistics.coverage.unrepresentable, 0.0) << degrees;
    EXPECT_LE(conversion->report.statistics.error.rms, 1.0) << degrees;
  }
  const std::optional<Conversion> whole = to(camera, "radtan");
  ASSERT_TRUE(whole);
  EXPECT_NEAR(whole->report.scored_to_deg, 66.0, 1e-9);
}

// ds has two minima for a lens that sees nearly all around, .1 px deep both: what is best inside an angle is not worse there
// than what is best inside a wider one.
TEST(Convert, ANarrowerFieldOfViewIsFittedNoWorseThanAWiderOne) {
  const Camera camera = test::make_camera(Intrinsics<Kb4>{{120.0, 120.0, 376.0, 376.0, 0.0, 0.0, 0.0, 0.0}}, {752, 752});
  for (const double degrees : {148.0, 150.0, 151.0, 152.0, 155.0, 160.0}) {
    Diagnostics diagnostics;
    const std::optional<Conversion> narrow = to(camera, "ds", diagnostics, degrees);
    const std::optional<Conversion> wide = to(camera, "ds", diagnostics, degrees + 1.0);
    const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, degrees * test::kRadians, diagnostics);
    ASSERT_TRUE(narrow && wide && field_of_view);
    const double rms = evaluate(camera.model, wide->camera.model, *field_of_view).error.rms;
    EXPECT_LE(narrow->report.statistics.error.rms, 1.005 * rms) << degrees;
  }
}

TEST(Convert, ATargetThatCannotReachTheLensIsFittedUpToASmallerAngle) {
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = to(test::tumvi(), "radtan", diagnostics, 97.5);
  ASSERT_TRUE(conversion);
  ASSERT_EQ(diagnostics.entries().size(), 1u);
  EXPECT_EQ(id_of(diagnostics.entries()[0]), "target-cannot-reach");
  EXPECT_EQ(diagnostics.entries()[0].severity, Severity::kWarning);
  EXPECT_LE(conversion->report.statistics.error.rms, 1.0);
  EXPECT_GT(conversion->report.statistics.coverage.unrepresentable, 0.3);
  EXPECT_GE(max_angle(conversion->camera.model), 60.0 * test::kRadians);
}

TEST(Convert, WithoutReducedAnglesATargetReachesAllOrNothing) {
  const auto converted = [](const std::string& model, double degrees, bool reduce_angle) {
    ConvertOptions options;
    options.model = model;
    options.max_angle_rad = degrees * test::kRadians;
    options.reduce_angle = reduce_angle;
    Diagnostics diagnostics;
    return convert(test::tumvi(), options, diagnostics);
  };
  EXPECT_FALSE(converted("radtan", 97.5, false)) << "it ends beyond 90 degrees";
  EXPECT_FALSE(converted("radtan", 75.0, false)) << "more than 1 px rms";
  EXPECT_TRUE(converted("radtan", 75.0, true));
  for (const auto& [model, degrees] : {std::pair{"radtan", 66.0}, std::pair{"eucm", 97.5}}) {
    const std::optional<Conversion> all = converted(model, degrees, false);
    const std::optional<Conversion> same = converted(model, degrees, true);
    ASSERT_TRUE(all && same) << model;
    EXPECT_EQ(all->camera.model, same->camera.model);
  }
}

TEST(Convert, APlaneGetsASmallerAngleWhereverTheLensEndsBeyond) {
  // Close to 90 degrees a plane is so large that a camera may be near all samples and a thousand pixels off between the last
  // one and the edge; and a pinhole reaches all, but describes nothing.
  struct Target {
    const char* model;
    double reaches_deg;
  };
  for (const Camera& camera : {test::tumvi(), test::lens_220(), test::woodscape_front(), test::t265_like()}) {
    for (const auto& [model, reaches_deg] : {Target{"radtan", 60.0}, Target{"rational", 85.0}}) {
      for (const double deg : {180.0, 110.0, 90.0, 89.9, 89.0, 86.0}) {
        Diagnostics diagnostics;
        const std::optional<Conversion> conversion = to(camera, model, diagnostics, deg);
        ASSERT_TRUE(conversion) << model << " " << deg;
        const ConversionReport& report = conversion->report;
        EXPECT_LE(report.statistics.error.rms, 1.0) << model << " " << deg;
        EXPECT_GE(report.scored_to_deg, reaches_deg - 1e-9) << model << " " << deg;
        EXPECT_GE(max_angle(conversion->camera.model), report.scored_to_deg * test::kRadians * (1.0 - 1e-9));
      }
    }
  }
}

TEST(Convert, ALensThatFoldsInsideTheImageIsSaid) {
  const Camera folded = test::make_camera(Intrinsics<Radtan>{{300, 300, 320, 240, -0.4, 0, 0, 0, 0}}, {640, 480});
  for (const char* target : {"radtan", "rational", "kb4"}) {
    Diagnostics diagnostics;
    ASSERT_TRUE(to(folded, target, diagnostics)) << target;
    ASSERT_EQ(diagnostics.entries().size(), 1u) << target;
    EXPECT_EQ(id_of(diagnostics.entries()[0]), "folds-inside-image");
    EXPECT_NEAR(std::get<double>(diagnostics.entries()[0].facts.arguments.at(1).value), 42.0, 0.5);
  }
}

// Whatever angle is asked for: the same cone is the same fit, and no wider one that is asked for outright would be as good.
TEST(Convert, AReducedAngleIsTheBestAndTheLargest) {
  std::map<long, double> rms_of_cone;
  for (const double deg : {85.5, 88.75, 89.0, 89.25, 90.0, 97.5}) {
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = to(test::tumvi(), "rational", diagnostics, deg);
    ASSERT_TRUE(conversion) << deg;
    if (diagnostics.entries().empty()) continue;
    const double rms = conversion->report.statistics.error.rms;
    const auto [known, is_first] = rms_of_cone.emplace(std::lround(conversion->report.scored_to_deg), rms);
    EXPECT_NEAR(rms / known->second, 1.0, 0.005) << deg;
  }
  EXPECT_FALSE(rms_of_cone.empty());

  for (const Camera& camera : {test::tumvi(), test::lens_220()}) {
    Diagnostics diagnostics;
    const std::optional<Conversion> cone = to(camera, "radtan", diagnostics);
    ASSERT_TRUE(cone);
    EXPECT_GT(cone->report.scored_to_deg, 60.0);
    const double wider = cone->report.scored_to_deg + 1.0;
    const std::optional<Conversion> other = to(camera, "radtan", diagnostics, wider);
    ASSERT_TRUE(other);
    EXPECT_TRUE(other->report.scored_to_deg < wider - 1e-6 || other->report.statistics.error.rms > 1.0);
  }
}

TEST(Convert, ScoredToIsTheFieldOfViewOrTheReducedAngle) {
  Diagnostics diagnostics;
  const std::optional<Conversion> whole = to(test::tumvi(), "eucm", diagnostics, 97.5);
  ASSERT_TRUE(whole);
  EXPECT_NEAR(whole->report.scored_to_deg, 97.5, 1e-9);
  const std::optional<Conversion> copy = to(test::tumvi(), "kb4", diagnostics, 97.5);
  ASSERT_TRUE(copy);
  EXPECT_NEAR(copy->report.scored_to_deg, 97.5, 1e-9);
  EXPECT_TRUE(diagnostics.entries().empty());
  const std::optional<Conversion> cone = to(test::tumvi(), "radtan", diagnostics, 97.5);
  ASSERT_TRUE(cone);
  const double end = cone->report.scored_to_deg;
  for (const ErrorBand& band : cone->report.statistics.bands) EXPECT_EQ(band.share > 0.0, band.from_deg < end) << band.from_deg;
  // Beyond, nothing was scored: evaluated without a cone there is more.
  const std::optional<FieldOfView> inside = field_of_view_of(test::tumvi(), end * test::kRadians, diagnostics);
  ASSERT_TRUE(inside);
  const ErrorStatistics evaluated = evaluate(test::tumvi().model, cone->camera.model, *inside);
  EXPECT_NEAR(evaluated.coverage.scored, cone->report.statistics.coverage.scored, 1e-3);
  EXPECT_NEAR(evaluated.error.rms, cone->report.statistics.error.rms, 1e-3 * evaluated.error.rms);
}

TEST(Convert, RangesOfTheTargetAreKept) {
  // EuRoC's lens wants alpha = 0.28; the EUCM forks of ORB-SLAM need more than 0.5.
  ConvertOptions options;
  options.model = "eucm";
  options.ranges = {{"alpha", 0.501, 1.0}};
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(test::euroc(), options, diagnostics);
  ASSERT_TRUE(conversion);
  EXPECT_DOUBLE_EQ(parameter(conversion->camera.model, "alpha").value(), 0.501);
  EXPECT_EQ(conversion->report.at_bound, std::vector<std::string>{"alpha"});
  EXPECT_TRUE(within(conversion->camera.model, options.ranges));

  options.model = "radtan";
  options.ranges = {{"k3", 0.0, 0.0}};
  const std::optional<Conversion> no_k3 = convert(test::kalibr_kb4(), options, diagnostics);
  ASSERT_TRUE(no_k3);
  EXPECT_EQ(parameter(no_k3->camera.model, "k3").value(), 0.0);
  EXPECT_TRUE(no_k3->report.at_bound.empty()) << "a fixed parameter is no bound that was hit";
}

TEST(Convert, ABestCameraAtAnOpenBoundIsFound) {
  // With alpha above 0.5 a pinhole, and a lens that bends outwards, is eucm for beta -> 0, where no eucm is.
  ConvertOptions options;
  options.model = "eucm";
  options.ranges = {{"alpha", 0.501, 1.0}};
  for (const CameraModel& model : std::vector<CameraModel>{Intrinsics<Pinhole>{{535.4, 539.2, 320.1, 247.6}},
                                                           Intrinsics<Radtan>{{520, 521, 325, 249, 0.05, 0.02, 0, 0, 0}}}) {
    const Camera camera = test::make_camera(model, {640, 480});
    const std::optional<Conversion> pinhole = to(camera, "pinhole");  // under 1 px: not to the image's corners
    ASSERT_TRUE(pinhole);
    options.max_angle_rad = pinhole->report.scored_to_deg * test::kRadians;
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
    ASSERT_TRUE(conversion) << model_info(model).id;
    EXPECT_EQ(conversion->report.at_bound, (std::vector<std::string>{"alpha", "beta"}));
    EXPECT_LE(conversion->report.statistics.error.rms, pinhole->report.statistics.error.rms + 1e-4);
  }
}

TEST(Convert, OcamcalibHoldsItsHigherCoefficientsUnlessAsked) {
  ConvertOptions options;
  options.model = "ocamcalib";
  options.degree = 4;
  Diagnostics diagnostics;
  const std::optional<Conversion> degree_4 = convert(test::euroc(), options, diagnostics);
  ASSERT_TRUE(degree_4);
  for (const ParameterId held : ParameterIds{"a1", "a5", "a6", "a7", "a8"})
    EXPECT_EQ(parameter(degree_4->camera.model, held), 0.0) << held.name();
  EXPECT_TRUE(degree_4->report.at_bound.empty());
  options.degree.reset();
  options.ranges = {{"a5", -1.0, 1.0}, {"a6", -1.0, 1.0}};
  const std::optional<Conversion> degree_6 = convert(test::euroc(), options, diagnostics);
  ASSERT_TRUE(degree_6);
  EXPECT_NE(parameter(degree_6->camera.model, "a6"), 0.0);
  EXPECT_LT(degree_6->report.statistics.error.rms, 0.8 * degree_4->report.statistics.error.rms);
}

TEST(Convert, APrincipalPointOnASampleIsFine) {
  // 101 x 101 pixels with the centre on a lattice point, a Gauss node and a pixel.
  const Camera camera = test::make_camera(Intrinsics<Kb4>{{40, 40, 50, 50, 0.01, 0, 0, 0}}, {101, 101});
  for (const ModelInfo& model : all_models()) {
    const std::optional<Conversion> conversion = to(camera, std::string(model.id));
    ASSERT_TRUE(conversion) << model.id;
    for (const double v : parameter_values(conversion->camera.model)) EXPECT_TRUE(std::isfinite(v)) << model.id;
    EXPECT_TRUE(std::isfinite(conversion->report.statistics.error.rms)) << model.id;
  }
}

TEST(Convert, EverythingButTheModelIsKept) {
  Camera camera = test::kalibr_ds();
  camera.time_offset_s = -0.0021;
  camera.frame_rate_hz = 20.0;
  camera.topic = "/cam0/image_raw";
  const std::optional<Conversion> conversion = to(camera, "eucm");
  ASSERT_TRUE(conversion);
  Camera expected = camera;
  expected.model = conversion->camera.model;
  EXPECT_EQ(conversion->camera, expected);
}

TEST(Convert, RandomDoubleSpheresAreFoundAgainToAHundredthOfAPixel) {
  // No far local minimum: the pixels of a ds, through a kb4 that describes them at least as well, lead back to a ds. (convert()
  // itself would copy a ds.) Valleys near the singular ridge xi = 0 end at errors below a thousandth of a pixel.
  constexpr double kHundredth = 0.01;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> alpha(0.4, 0.75);
  std::uniform_real_distribution<double> xi(-0.5, 0.8);
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    const CameraModel model = Intrinsics<Ds>{{200.0, 201.0, 320.0, 240.0, alpha(random), xi(random)}};
    const Camera camera = test::make_camera(model, {640, 480});
    Diagnostics diagnostics;
    const double limit = std::min(80.0, 0.95 * max_angle(model) / test::kRadians);
    const std::optional<Conversion> kb4 = to(camera, "kb4", diagnostics, limit);
    ASSERT_TRUE(kb4);
    if (kb4->report.statistics.error.rms > kHundredth) continue;
    const std::optional<Conversion> back = to(kb4->camera, "ds", diagnostics, limit);
    ASSERT_TRUE(back);
    EXPECT_LE(back->report.statistics.error.rms, kHundredth)
        << parameter(model, "alpha").value() << " " << parameter(model, "xi").value();
    ++compared;
  }
  EXPECT_GT(compared, 80);
}

TEST(Convert, NonsenseIsRefusedInWords) {
  struct Case {
    Camera camera;
    const char* model;
    const char* code;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Camera no_size = test::tumvi();
  no_size.image_size.reset();
  const std::vector<Case> cases = {
      {test::tumvi(), "fish", "unknown-model"},
      {no_size, "eucm", "image-size-missing"},
      {test::make_camera(test::tumvi().model, {0, 512}), "eucm", "image-size-invalid"},
      {test::make_camera(test::tumvi().model, {-5, 512}), "eucm", "image-size-invalid"},
      {test::make_camera(test::tumvi().model, {2'000'000'000, 2'000'000'000}), "eucm", "image-size-invalid"},
      {test::make_camera(Intrinsics<Pinhole>{{nan, 400, 320, 240}}, {640, 480}), "eucm", "not-a-camera"},
      {test::make_camera(Intrinsics<Pinhole>{{-400, 400, 320, 240}}, {640, 480}), "eucm", "not-a-camera"},
      {test::make_camera(Intrinsics<Pinhole>{{1e308, 400, 320, 240}}, {640, 480}), "eucm", "not-a-camera"},
      {test::make_camera(Intrinsics<Eucm>{{400, 400, 320, 240, 1.5, 1}}, {640, 480}), "kb4", "not-a-camera"},
      {test::make_camera(Intrinsics<Ucm>{{10, 10, 1e6, 1e6, 0.9}}, {640, 480}), "kb4", "no-pixel-has-a-ray"},
  };
  for (const Case& c : cases) {
    Diagnostics diagnostics;
    EXPECT_FALSE(to(c.camera, c.model, diagnostics)) << c.code;
    ASSERT_FALSE(diagnostics.entries().empty()) << c.code;
    EXPECT_EQ(id_of(diagnostics.entries().front()), c.code);
    EXPECT_FALSE(diagnostics.entries().front().facts.arguments.empty());
  }
}

TEST(Convert, DegenerateCamerasEndWithoutGarbage) {
  const std::vector<Camera> cameras = {
      test::make_camera(Intrinsics<Radtan>{{300, 300, 320, 240, -0.4, 0, 0, 0, 0}}, {640, 480}),  // folds inside the image
      test::make_camera(Intrinsics<Ucm>{{300, 300, 320, 240, 0.0}}, {640, 480}),
      test::make_camera(Intrinsics<Ucm>{{300, 300, 320, 240, 1.0}}, {640, 480}),
      test::make_camera(Intrinsics<Pinhole>{{300, 300, 0, 0}}, {1, 1}),
      test::make_camera(Intrinsics<Pinhole>{{30000, 300, 320, 240}}, {640, 480}),
      test::make_camera(Intrinsics<Kb4>{{300, 300, -4000, 9000, 0, 0, 0, 0}}, {640, 480}),
      test::make_camera(Intrinsics<Kb4>{{1e-3, 1e-3, 320, 240, 0, 0, 0, 0}}, {640, 480}),
  };
  for (const Camera& camera : cameras) {
    for (const ModelInfo& model : all_models()) {
      Diagnostics diagnostics;
      const std::optional<Conversion> conversion = to(camera, std::string(model.id), diagnostics);
      if (!conversion) {
        EXPECT_TRUE(diagnostics.has_errors()) << model.id;
        continue;
      }
      EXPECT_TRUE(validate(conversion->camera.model).empty()) << model.id;
      EXPECT_TRUE(std::isfinite(conversion->report.statistics.error.rms)) << model.id;
      EXPECT_TRUE(std::isfinite(conversion->report.statistics.error.max)) << model.id;
    }
  }
}

/// The largest distance between source and target over pixels of our own, as far from the axis as the conversion is scored.
double largest_error(const Camera& source, const Conversion& conversion) {
  constexpr int kSteps = 40;
  double largest = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Pixel pixel = {(source.image_size->width - 1.0) * i / kSteps, (source.image_size->height - 1.0) * j / kSteps};
      const std::optional<Ray> ray = unproject(source.model, pixel);
      if (!ray || angle_from_axis(*ray) > conversion.report.scored_to_deg * test::kRadians) continue;
      const std::optional<Pixel> other = project(conversion.camera.model, *ray);
      if (other) largest = std::max(largest, std::hypot((*other)[0] - pixel[0], (*other)[1] - pixel[1]));
    }
  }
  return largest;
}

TEST(Convert, DegenerateCamerasEndInADiagnosticOrARightResult) {
  struct Case {
    const char* what;
    Camera camera;
    std::vector<const char*> exact;    ///< Targets that hold it.
    std::vector<const char*> good;     ///< Targets that describe all that it sees of its image, to half a pixel rms.
    std::vector<const char*> refused;  ///< Targets, or "all".
    const char* code;                  ///< Of the refusal.
    const char* warning = "";          ///< What every conversion says.
  };
  const std::vector<Case> cases = {
      {"folded",
       test::make_camera(Intrinsics<Radtan>{{300, 300, 320, 240, -0.4, 0, 0, 0, 0}}, {640, 480}),
       {"rational"},
       {},
       {},
       ""},
      {"alpha 0",
       test::make_camera(Intrinsics<Ucm>{{300, 300, 320, 240, 0.0}}, {640, 480}),
       {"pinhole", "radtan", "rational", "eucm", "ds", "mei"},
       {},
       {},
       ""},
      {"alpha 1", test::make_camera(Intrinsics<Ucm>{{300, 300, 320, 240, 1.0}}, {640, 480}), {"eucm", "ds"}, {"kb4"}, {}, ""},
      {"one pixel",
       test::make_camera(Intrinsics<Kb4>{{300, 300, 0, 0, 0.01, 0, 0, 0}}, {1, 1}),
       {"kb4", "woodscape"},
       {},
       {"pinhole", "radtan", "rational", "ucm", "eucm", "ds", "mei", "fov", "ocamcalib"},
       "domain-too-small"},
      {"fx / fy = 100",
       test::make_camera(Intrinsics<Pinhole>{{30000, 300, 320, 240}}, {640, 480}),
       {"radtan", "rational", "ucm", "eucm", "ds", "mei"},
       {"kb4", "fov"},
       {},
       "",
       "focal-lengths-differ"},
      {"principal point 10,000 px away",
       test::make_camera(Intrinsics<Kb4>{{300, 300, -4000, 9000, 0, 0, 0, 0}}, {640, 480}),
       {},
       {},
       {"pinhole", "radtan", "rational", "ucm", "eucm", "ds", "mei", "fov", "ocamcalib", "woodscape"},
       "no-pixel-has-a-ray"},
      {"principal point beside the image",
       test::make_camera(Intrinsics<Kb4>{{300, 300, -200, 240, 0.01, 0, 0, 0}}, {640, 480}),
       {"woodscape"},
       {},
       {},
       "",
       "centre-outside"},
  };
  const auto among = [](const std::vector<const char*>& list, std::string_view id) {
    return std::ranges::any_of(list, [id](const char* name) { return name == id; });
  };
  for (const Case& c : cases) {
    for (const ModelInfo& model : all_models()) {
      SCOPED_TRACE(std::string(c.what) + " -> " + std::string(model.id));
      Diagnostics diagnostics;
      const std::optional<Conversion> conversion = to(c.camera, std::string(model.id), diagnostics);
      if (among(c.refused, model.id)) {
        EXPECT_FALSE(conversion);
        ASSERT_TRUE(diagnostics.has_errors());
        EXPECT_EQ(id_of(diagnostics.entries().front()), c.code);
      }
      if (!conversion) {
        EXPECT_TRUE(diagnostics.has_errors());
        EXPECT_FALSE(among(c.exact, model.id) || among(c.good, model.id));
        continue;
      }
      const bool said = std::ranges::any_of(diagnostics.entries(), [&c](const Diagnostic& d) { return id_of(d) == c.warning; });
      EXPECT_EQ(said, *c.warning != '\0');
      const ErrorStatistics& statistics = conversion->report.statistics;
      const Coverage& coverage = statistics.coverage;
      EXPECT_NEAR(coverage.scored + coverage.outside_lens + coverage.unrepresentable, 1.0, 1e-9);
      EXPECT_TRUE(validate(conversion->camera.model).empty());
      constexpr double kNobodySees = 1e-6;  // px
      EXPECT_LE(largest_error(c.camera, *conversion), 1.001 * statistics.error.max + kNobodySees) << "what is said is true";
      if (among(c.exact, model.id)) {
        EXPECT_TRUE(conversion->report.exact);
        EXPECT_LE(statistics.error.max, 1e-9);
      }
      if (among(c.good, model.id)) {
        EXPECT_LE(statistics.error.rms, 0.5);
        EXPECT_EQ(coverage.unrepresentable, 0.0);
      }
    }
  }
}

TEST(Convert, ALensFoldedInsideTheImageIsItsPartBeforeTheFold) {
  // r (1 - 0.4 r^2) grows until r = sqrt(1 / 1.2): 42.4 degrees, 182.6 px from the centre.
  const Camera camera = test::make_camera(Intrinsics<Radtan>{{300, 300, 320, 240, -0.4, 0, 0, 0, 0}}, {640, 480});
  const double fold = std::atan(std::sqrt(1.0 / 1.2)) / test::kRadians;
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = to(camera, "kb4", diagnostics);
  ASSERT_TRUE(conversion);
  const Coverage& coverage = conversion->report.statistics.coverage;
  EXPECT_NEAR(coverage.max_angle_deg, fold, 1e-6);
  EXPECT_EQ(coverage.why.code, Code::kFieldOfViewModelEnds);
  const double radius = 300.0 * std::sqrt(1.0 / 1.2) * (1.0 - 0.4 / 1.2);
  EXPECT_NEAR(coverage.scored + coverage.unrepresentable, std::numbers::pi * radius * radius / (640.0 * 480.0), 2e-3);
  EXPECT_LE(conversion->report.scored_to_deg, fold + 1e-9);
}

}  // namespace
}  // namespace fca
