// SPDX-License-Identifier: BSD-3-Clause
// Two cameras: the evaluation is that of conversions, the best rotation is found, and image sizes are matched or refused.
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

void expect_same(const ErrorStatistics& a, const ErrorStatistics& b) {
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
    EXPECT_EQ(result.difference.statistics.error.max, 0.0);
    EXPECT_EQ(result.difference.statistics.error.rms, 0.0);
    EXPECT_EQ(result.difference.angle.max_deg, 0.0);
    EXPECT_GT(result.difference.statistics.coverage.scored, 0.9);
    EXPECT_EQ(result.difference.same_to_deg, result.difference.statistics.coverage.max_angle_deg);
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
        expect_same(result.difference.statistics, conversion->report.statistics);
        EXPECT_EQ(result.scored_to_deg, conversion->report.scored_to_deg);
      }
    }
  }
}

// Beyond the cone to which a model was fitted, convert does not score; whoever compares says where that ends.
TEST(CompareCameras, OfAReducedAngleItIsTheConversionsReportUnderThatAngle) {
  Diagnostics diagnostics;
  ConvertOptions options;
  options.model = "radtan";
  const std::optional<Conversion> conversion = convert(tumvi(), options, diagnostics);
  ASSERT_TRUE(conversion);
  CompareOptions compare_options;
  compare_options.max_angle_rad = conversion->report.scored_to_deg * kRadians;
  const CameraComparison result = compared(tumvi(), conversion->camera, compare_options);
  const ErrorSummary& error = result.difference.statistics.error;
  EXPECT_NEAR(error.rms, conversion->report.statistics.error.rms, 0.01 * error.rms);
  EXPECT_NEAR(error.max, conversion->report.statistics.error.max, 0.01 * error.max);
}

TEST(CompareCameras, BothDirectionsAgreeWhereTheCamerasAreNear) {
  const CameraComparison there = compared(kalibr_eucm(), kalibr_ds());
  const CameraComparison back = compared(kalibr_ds(), kalibr_eucm());
  EXPECT_GT(there.difference.statistics.error.rms, 0.01);
  EXPECT_NEAR(there.difference.statistics.error.rms, back.difference.statistics.error.rms,
              0.03 * there.difference.statistics.error.rms);
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
  EXPECT_NEAR(result.difference.statistics.error.max, 2.0, 0.1);
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
    const std::optional<FieldOfView> field_of_view =
        field_of_view_of(lens, *camera.image_size, std::nullopt, "lens", diagnostics);
    ASSERT_TRUE(field_of_view);
    const std::optional<Transform> found = internal::best_rotation(lens, camera.model, *field_of_view);
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
    EXPECT_LE(result.rotated->difference.statistics.error.rms, 1.001 * result.difference.statistics.error.rms);
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
  EXPECT_LT(result.rotated->difference.statistics.error.rms, 0.1 * result.difference.statistics.error.rms);
}

/// The lens that sees points at `distance_m` where `camera` sees them, which is turned and moved against it by T: for each ray
/// of the camera, where it meets the sphere of that radius about the lens.
Lens lens_beside(const Camera& camera, const Transform& T_camera_lens, double distance_m) {
  const Transform back = inverse(T_camera_lens).value();
  const std::array<double, 3> t = translation_of(T_camera_lens);
  return Lens(
      [&camera, back, t, distance_m](const Pixel& pixel) -> std::optional<Ray> {
        const std::optional<Ray> ray = unproject(camera.model, pixel);
        if (!ray) return std::nullopt;
        const double along = (*ray)[0] * t[0] + (*ray)[1] * t[1] + (*ray)[2] * t[2];
        const double square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
        const double depth = along + std::sqrt(along * along - square + distance_m * distance_m);
        Ray point;
        for (std::size_t i = 0; i < 3; ++i) point[i] = (depth * (*ray)[i] - t[i]) / distance_m;
        return rotated(back, point);
      },
      {central_focal_lengths(camera.model), principal_point(camera.model)});
}

TEST(CompareCameras, AShiftOfTheProjectionCentreIsFound) {
  Diagnostics diagnostics;
  for (const Camera& camera : {tumvi(), euroc(), kalibr_ds()}) {
    for (const double distance_m : {0.3, 2.0, 50.0}) {
      for (const double turn : {0.0, 0.02}) {
        Transform T;
        T.values = {std::cos(turn),  0, std::sin(turn), 0.004, 0, 1, 0, -0.007,
                    -std::sin(turn), 0, std::cos(turn), 0.011, 0, 0, 0, 1};
        const Lens lens = lens_beside(camera, T, distance_m);
        const std::optional<FieldOfView> field_of_view =
            field_of_view_of(lens, *camera.image_size, 60.0 * kRadians, "lens", diagnostics);
        ASSERT_TRUE(field_of_view);
        const std::optional<Transform> found = internal::best_rotation(lens, camera.model, *field_of_view, distance_m);
        ASSERT_TRUE(found);
        for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(found->values[i], T.values[i], 1e-6) << distance_m << " " << i;
        // Without a distance, it is all a turn.
        const std::optional<Transform> rotation = internal::best_rotation(lens, camera.model, *field_of_view);
        ASSERT_TRUE(rotation);
        for (const int row : {0, 1, 2}) EXPECT_EQ((*rotation)(row, 3), 0.0);
      }
    }
  }
}

/// The rms over a grid of the image's pixels up to an angle, of points at a distance that T moves.
double rms_on_grid(const Camera& reference, const Camera& other, double limit_rad, const Transform& T, double distance_m) {
  double squares = 0.0;
  int count = 0;
  for (double u = 0.0; u < reference.image_size->width; u += 4.0) {
    for (double v = 0.0; v < reference.image_size->height; v += 4.0) {
      const std::optional<Ray> ray = unproject(reference.model, {u, v});
      if (!ray || std::acos((*ray)[2]) > limit_rad) continue;
      Ray point = rotated(T, *ray);
      for (int i = 0; i < 3; ++i) point[static_cast<std::size_t>(i)] += T(i, 3) / distance_m;
      const std::optional<Pixel> pixel = project(other.model, point);
      if (!pixel) continue;
      squares += std::pow((*pixel)[0] - u, 2) + std::pow((*pixel)[1] - v, 2);
      ++count;
    }
  }
  return std::sqrt(squares / count);
}

TEST(CompareCameras, ARotationAndTranslationAreTheBest) {
  constexpr double kLimit = 40.0 * kRadians;
  constexpr double kDistance = 1.5;
  for (const auto& [reference, other] : {std::pair(kalibr_ds(), kalibr_eucm()), std::pair(kalibr_radtan(), kalibr_kb4())}) {
    const CameraComparison turned = compared(reference, other, {.max_angle_rad = kLimit});
    const CameraComparison moved = compared(reference, other, {.max_angle_rad = kLimit, .distance_m = kDistance});
    ASSERT_TRUE(turned.rotated && moved.rotated);
    EXPECT_EQ(turned.rotated->centre_m, (std::array<double, 3>{}));
    EXPECT_EQ(moved.rotated->distance_m, kDistance);
    EXPECT_LE(moved.rotated->difference.statistics.error.rms, 1.001 * turned.rotated->difference.statistics.error.rms);
    const Transform& T = moved.rotated->T_other_reference;
    const double best = rms_on_grid(reference, other, kLimit, T, kDistance);
    EXPECT_NEAR(moved.rotated->difference.statistics.error.rms, best, 0.01 * best);
    for (const int row : {0, 1, 2}) {
      for (const double step_m : {-2e-3, 2e-3}) {
        Transform beside = T;
        beside(row, 3) += step_m;
        EXPECT_GT(rms_on_grid(reference, other, kLimit, beside, kDistance), best);
      }
    }
    // Its centre is what T takes to the origin.
    for (int row = 0; row < 3; ++row) {
      double element = T(row, 3);
      for (int i = 0; i < 3; ++i) element += T(row, i) * moved.rotated->centre_m[static_cast<std::size_t>(i)];
      EXPECT_NEAR(element, 0.0, 1e-12);
    }
  }
}

TEST(CompareCameras, InFocusAreTheRegionsRaysOnly) {
  for (const auto& [reference, other] : {std::pair(kalibr_ds(), kalibr_radtan()), std::pair(kalibr_kb4(), kalibr_eucm())}) {
    for (const double degrees : {15.0, 35.0}) {
      const double limit = degrees * kRadians;
      const CameraComparison whole = compared(reference, other);
      const CameraComparison region = compared(reference, other, {.max_angle_rad = limit});
      const CameraComparison focused = compared(reference, other, {.focus_rad = limit});
      ASSERT_TRUE(focused.focus && focused.rotated && focused.focus->rotated && region.rotated);
      EXPECT_NEAR(focused.focus->max_angle_deg, degrees, 1e-9);
      expect_same(focused.focus->difference.statistics, region.difference.statistics);
      expect_same(focused.focus->rotated->statistics, region.rotated->difference.statistics);
      EXPECT_EQ(focused.rotated->T_other_reference, region.rotated->T_other_reference);
      expect_same(focused.difference.statistics, whole.difference.statistics);
      EXPECT_EQ(&focused.decisive(), &focused.focus->difference);
      const double rms = rms_on_grid(reference, other, limit, Transform(), 1.0);
      EXPECT_NEAR(focused.focus->difference.statistics.error.rms, rms, 0.02 * rms);
      const double turned = rms_on_grid(reference, other, limit, focused.rotated->T_other_reference, 1.0);
      EXPECT_NEAR(focused.focus->rotated->statistics.error.rms, turned, 0.02 * turned);
      EXPECT_GE(rms_on_grid(reference, other, limit, whole.rotated->T_other_reference, 1.0), 0.999 * turned);
    }
  }
}

// The narrower of two limits counts.
TEST(CompareCameras, FocusEndsWithTheLens) {
  const CameraComparison result =
      compared(kalibr_ds(), kalibr_eucm(), {.max_angle_rad = 20.0 * kRadians, .focus_rad = 50.0 * kRadians});
  ASSERT_TRUE(result.focus);
  EXPECT_NEAR(result.focus->max_angle_deg, 20.0, 1e-9);
  expect_same(result.focus->difference.statistics, result.difference.statistics);
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
  EXPECT_LT(result.difference.statistics.error.max, 1e-9);
  const CameraComparison back = compared(*large, camera);
  EXPECT_EQ(back.size, (ImageSize{1024, 1024}));
  EXPECT_LT(back.difference.statistics.error.max, 1e-9);
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
    EXPECT_EQ(same.difference.statistics.error.max, 0.0);
    EXPECT_NEAR(same.size.width, size.width, 0.1 * size.width);
    EXPECT_NEAR(same.size.height, size.height, 0.1 * size.height);
    Camera moved = camera;
    ASSERT_TRUE(set_parameter(moved.model, "cx", principal_point(camera.model)[0] + 2.0));
    const CameraComparison result = compared(camera, moved);
    EXPECT_FALSE(result.identical);
    EXPECT_EQ(result.size, same.size);
    EXPECT_NEAR(result.difference.statistics.error.max, 2.0, 1e-9);
  }
}

TEST(CompareCameras, ALensThatSeesNothingIsTheSameAsItself) {
  const Camera blind = {"cam0", ImageSize{512, 512}, Intrinsics<Kb4>{{10.0, 10.0, 5000.0, 256.5, -0.3, 0.0, 0.0, 0.0}}, {}, {},
                        {}};
  Diagnostics diagnostics;
  const std::optional<CameraComparison> same = compare(blind, blind, {}, diagnostics);
  ASSERT_TRUE(same);
  EXPECT_TRUE(same->identical);
  EXPECT_EQ(same->difference.statistics.error.max, 0.0);
  ASSERT_EQ(diagnostics.entries().size(), 1U);
  EXPECT_EQ(id_of(diagnostics.entries().front()), "no-pixel-has-a-ray");
  EXPECT_FALSE(diagnostics.has_errors());
  Camera other = blind;
  ASSERT_TRUE(set_parameter(other.model, "cx", 4999.0));
  EXPECT_FALSE(compare(blind, other, {}, diagnostics));
}

}  // namespace
}  // namespace fca::test
