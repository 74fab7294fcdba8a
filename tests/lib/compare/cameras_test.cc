// SPDX-License-Identifier: BSD-3-Clause
// Two cameras: the judge is that of conversions, the best rotation is found, and image sizes are matched or refused.
#include "compare/best_rotation.h"
#include "lib/convert/known_cameras.h"

#include <fca/compare/compare.h>
#include <fca/convert/convert.h>
#include <fca/rig/image_change.h>
#include <fca/rig/rotation.h>

#include <cmath>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

CameraComparison compared(const Camera& reference, const Camera& other, const CompareOptions& options = {}) {
  Diagnostics diagnostics;
  const std::optional<CameraComparison> result = compare(reference, other, options, diagnostics);
  EXPECT_TRUE(result) << (diagnostics.entries().empty() ? "" : id_of(diagnostics.entries().front()));
  return result.value_or(CameraComparison());
}

void expect_same(const Judgement& a, const Judgement& b) {
  EXPECT_EQ(a.coverage.max_angle_deg, b.coverage.max_angle_deg);
  EXPECT_EQ(a.coverage.why, b.coverage.why);
  EXPECT_EQ(a.coverage.scored, b.coverage.scored);
  EXPECT_EQ(a.coverage.outside_lens, b.coverage.outside_lens);
  EXPECT_EQ(a.coverage.unrepresentable, b.coverage.unrepresentable);
  EXPECT_EQ(a.error.rms, b.error.rms);
  EXPECT_EQ(a.error.p95, b.error.p95);
  EXPECT_EQ(a.error.max, b.error.max);
  EXPECT_EQ(a.error.bound, b.error.bound);
  ASSERT_EQ(a.bands.size(), b.bands.size());
  for (std::size_t i = 0; i < a.bands.size(); ++i) {
    EXPECT_EQ(a.bands[i].share, b.bands[i].share);
    EXPECT_EQ(a.bands[i].rms_px, b.bands[i].rms_px);
    EXPECT_EQ(a.bands[i].max_px, b.bands[i].max_px);
  }
}

TEST(CompareCameras, ACameraIsExactlyItself) {
  for (const Camera& camera : {kalibr_ds(), kalibr_eucm(), kalibr_kb4(), kalibr_radtan(), euroc(), tumvi()}) {
    const CameraComparison result = compared(camera, camera);
    EXPECT_TRUE(result.identical);
    EXPECT_EQ(result.difference.judgement.error.max, 0.0);
    EXPECT_EQ(result.difference.judgement.error.rms, 0.0);
    EXPECT_EQ(result.difference.angle.max_deg, 0.0);
    EXPECT_GT(result.difference.judgement.coverage.scored, 0.9);
    EXPECT_EQ(result.difference.same_to_deg, result.difference.judgement.coverage.max_angle_deg);
  }
}

TEST(CompareCameras, WithAConversionItIsTheConversionsReport) {
  for (const Camera& camera : {kalibr_ds(), kalibr_kb4(), kalibr_radtan(), tumvi()}) {
    for (const char* model : {"eucm", "ds", "kb4", "ocamcalib", "ucm"}) {
      for (const std::optional<double> limit : {std::optional<double>(), std::optional(30.0 * kRadians)}) {
        SCOPED_TRACE(std::string(model) + " from " + std::string(model_info(camera.model).id));
        Diagnostics diagnostics;
        ConvertOptions options;
        options.model = model;
        options.max_angle_rad = limit;
        const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
        ASSERT_TRUE(conversion);
        CompareOptions compare_options;
        compare_options.max_angle_rad = limit;
        const CameraComparison result = compared(camera, conversion->camera, compare_options);
        if (result.identical) continue;
        expect_same(result.difference.judgement, conversion->report.judgement);
        EXPECT_EQ(result.scored_to_deg, conversion->report.scored_to_deg);
      }
    }
  }
}

// Beyond the cone to which a model was fitted, convert does not score; whoever compares says where that ends.
TEST(CompareCameras, OfAConeItIsTheConversionsReportUnderTheConesAngle) {
  Diagnostics diagnostics;
  ConvertOptions options;
  options.model = "radtan";
  const std::optional<Conversion> conversion = convert(tumvi(), options, diagnostics);
  ASSERT_TRUE(conversion);
  CompareOptions compare_options;
  compare_options.max_angle_rad = conversion->report.scored_to_deg * kRadians;
  const CameraComparison result = compared(tumvi(), conversion->camera, compare_options);
  const ErrorSummary& error = result.difference.judgement.error;
  EXPECT_NEAR(error.rms, conversion->report.judgement.error.rms, 0.01 * error.rms);
  EXPECT_NEAR(error.max, conversion->report.judgement.error.max, 0.01 * error.max);
}

TEST(CompareCameras, BothDirectionsAgreeWhereTheCamerasAreNear) {
  const CameraComparison there = compared(kalibr_eucm(), kalibr_ds());
  const CameraComparison back = compared(kalibr_ds(), kalibr_eucm());
  EXPECT_GT(there.difference.judgement.error.rms, 0.01);
  EXPECT_NEAR(there.difference.judgement.error.rms, back.difference.judgement.error.rms,
              0.03 * there.difference.judgement.error.rms);
  EXPECT_NEAR(there.difference.angle.rms_deg, back.difference.angle.rms_deg, 0.03 * there.difference.angle.rms_deg);
  ASSERT_TRUE(there.rotated);
  ASSERT_TRUE(back.rotated);
  EXPECT_NEAR(there.rotated->angle_rad, back.rotated->angle_rad, 0.05 * there.rotated->angle_rad);
}

// Whatever the ray, its pixels' distance is the angle times the local pixels per radian.
TEST(CompareCameras, DegreesAreThoseBetweenTheRaysOfAPixel) {
  Camera other = euroc();
  ASSERT_TRUE(set_parameter(other.model, "cx", *parameter(other.model, "cx") + 2.0));
  const CameraComparison result = compared(euroc(), other);
  const Pixel at = result.difference.angle.max_at;
  const std::optional<Ray> a = unproject(euroc().model, at);
  const std::optional<Ray> b = unproject(other.model, at);
  ASSERT_TRUE(a && b);
  const double cosine = (*a)[0] * (*b)[0] + (*a)[1] * (*b)[1] + (*a)[2] * (*b)[2];
  EXPECT_NEAR(result.difference.angle.max_deg, std::acos(cosine) / kRadians, 1e-6);
  EXPECT_NEAR(result.difference.judgement.error.max, 2.0, 0.1);
}

TEST(CompareCameras, TheBestRotationIsFound) {
  const Camera camera = tumvi();
  Diagnostics diagnostics;
  for (const double degrees : {1e-4, 0.3, 5.0, 40.0}) {
    // A lens that sees by R^T what the camera sees: turned by R it is the camera.
    const double c = std::cos(degrees * kRadians);
    const double s = std::sin(degrees * kRadians);
    Transform R;
    R.values = {c, -0.6 * s, 0.8 * s, 0, 0.6 * s, 0.64 + 0.36 * c, 0.48 * (1 - c), 0, -0.8 * s, 0.48 * (1 - c), 0.36 + 0.64 * c,
                0, 0,        0,       0, 1};
    ASSERT_LT(rotation_defect(R), 1e-12);
    Transform back;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) back(row, column) = R(column, row);
    }
    const Lens lens(
        [&](const Pixel& pixel) -> std::optional<Ray> {
          const std::optional<Ray> ray = unproject(camera.model, pixel);
          return ray ? std::optional(rotated(back, *ray)) : std::nullopt;
        },
        {central_focal_lengths(camera.model), principal_point(camera.model)});
    const std::optional<Domain> domain = domain_of(lens, *camera.image_size, std::nullopt, "lens", diagnostics);
    ASSERT_TRUE(domain);
    const std::optional<Transform> found = internal::best_rotation(lens, camera.model, *domain);
    ASSERT_TRUE(found);
    for (int i = 0; i < 16; ++i)
      EXPECT_NEAR(found->values[static_cast<std::size_t>(i)], R.values[static_cast<std::size_t>(i)], 1e-9) << degrees;
    const std::array<double, 3> vector = rotation_vector(*found);
    EXPECT_NEAR(vector[0], 0.0, 1e-9);
    EXPECT_NEAR(vector[1], 0.8 * degrees * kRadians, 1e-9);
    EXPECT_NEAR(vector[2], 0.6 * degrees * kRadians, 1e-9);
  }
}

TEST(CompareCameras, ARotationNeverMakesItWorse) {
  for (const auto& [reference, other] : {std::pair(kalibr_ds(), kalibr_radtan()), std::pair(kalibr_kb4(), kalibr_eucm()),
                                         std::pair(euroc(), kalibr_radtan()), std::pair(kalibr_radtan(), euroc())}) {
    const CameraComparison result = compared(reference, other);
    ASSERT_TRUE(result.rotated);
    EXPECT_LE(result.rotated->difference.judgement.error.rms, 1.001 * result.difference.judgement.error.rms);
  }
}

// A principal point that is off by a little is a rotation by as many pixels per focal length.
TEST(CompareCameras, AShiftedCentreIsARotation) {
  Camera other = tumvi();
  ASSERT_TRUE(set_parameter(other.model, "cx", *parameter(other.model, "cx") - 1.0));
  const CameraComparison result = compared(tumvi(), other, {.max_angle_rad = 20.0 * kRadians});
  ASSERT_TRUE(result.rotated);
  EXPECT_NEAR(result.rotated->angle_rad, 1.0 / 190.97, 2e-4);
  EXPECT_GT(result.rotated->vector_rad[1], 0.0) << "the same pixel looks further to the right";
  EXPECT_LT(result.rotated->difference.judgement.error.rms, 0.1 * result.difference.judgement.error.rms);
}

TEST(CompareCameras, TheAngleToWhichTheyAreTheSame) {
  Camera other = tumvi();
  ASSERT_TRUE(set_parameter(other.model, "k4", *parameter(other.model, "k4") + 1e-4));
  const CameraComparison result = compared(tumvi(), other);
  const double radians = result.difference.same_to_deg * kRadians;
  // The radius differs by fx 1e-4 theta^9.
  EXPECT_NEAR(190.97 * 1e-4 * std::pow(radians, 9), kSamePx, 0.02);
}

TEST(CompareCameras, ImagesOfAnotherSizeAreScaled) {
  const Camera camera = tumvi();
  Diagnostics diagnostics;
  const std::optional<Camera> large = with_changed_images(camera, {.resize = ImageSize{1024, 1024}}, diagnostics);
  ASSERT_TRUE(large);
  const CameraComparison result = compared(camera, *large);
  EXPECT_FALSE(result.identical);
  EXPECT_EQ(result.other_size, (ImageSize{1024, 1024}));
  EXPECT_LT(result.difference.judgement.error.max, 1e-9);
  const CameraComparison back = compared(*large, camera);
  EXPECT_EQ(back.size, (ImageSize{1024, 1024}));
  EXPECT_LT(back.difference.judgement.error.max, 1e-9);
}

TEST(CompareCameras, OtherProportionsAreRefusedAndASizeIsEnoughOnce) {
  Camera other = euroc();
  other.image_size = ImageSize{752, 500};
  Diagnostics diagnostics;
  EXPECT_FALSE(compare(euroc(), other, {}, diagnostics));
  ASSERT_EQ(diagnostics.entries().size(), 1U);
  EXPECT_EQ(id_of(diagnostics.entries().front()), "resolution-differs");
  other.image_size.reset();
  EXPECT_TRUE(compared(euroc(), other).identical);
  EXPECT_TRUE(compared(other, euroc()).identical);
  EXPECT_FALSE(compared(other, euroc()).size_assumed);
}

// The image whose middle is the principal point.
TEST(CompareCameras, WithoutAnySizeOneIsAssumed) {
  for (Camera camera : {kalibr_ds(), kalibr_kb4(), kalibr_radtan(), euroc()}) {
    const ImageSize size = *camera.image_size;
    camera.image_size.reset();
    const CameraComparison same = compared(camera, camera);
    EXPECT_TRUE(same.identical && same.size_assumed);
    EXPECT_EQ(same.difference.judgement.error.max, 0.0);
    EXPECT_NEAR(same.size.width, size.width, 0.1 * size.width);
    EXPECT_NEAR(same.size.height, size.height, 0.1 * size.height);
    Camera moved = camera;
    ASSERT_TRUE(set_parameter(moved.model, "cx", principal_point(camera.model)[0] + 2.0));
    const CameraComparison result = compared(camera, moved);
    EXPECT_FALSE(result.identical);
    EXPECT_EQ(result.size, same.size);
    EXPECT_NEAR(result.difference.judgement.error.max, 2.0, 1e-9);
  }
}

TEST(CompareCameras, ALensThatSeesNothingIsTheSameAsItself) {
  const Camera blind = {"cam0", ImageSize{512, 512}, Intrinsics<Kb4>{{10.0, 10.0, 5000.0, 256.5, -0.3, 0.0, 0.0, 0.0}}, {}, {},
                        {}};
  Diagnostics diagnostics;
  const std::optional<CameraComparison> same = compare(blind, blind, {}, diagnostics);
  ASSERT_TRUE(same);
  EXPECT_TRUE(same->identical);
  EXPECT_EQ(same->difference.judgement.error.max, 0.0);
  ASSERT_EQ(diagnostics.entries().size(), 1U);
  EXPECT_EQ(id_of(diagnostics.entries().front()), "no-pixel-has-a-ray");
  EXPECT_FALSE(diagnostics.has_errors());
  Camera other = blind;
  ASSERT_TRUE(set_parameter(other.model, "cx", 4999.0));
  EXPECT_FALSE(compare(blind, other, {}, diagnostics));
}

}  // namespace
}  // namespace fca::test
