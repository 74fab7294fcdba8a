// SPDX-License-Identifier: BSD-3-Clause
// The limit below which no fit comes, against fits, and against cameras of the model.
#include "known_cameras.h"

#include <fca/convert/convert.h>
#include <fca/convert/least_error.h>

#include <limits>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

constexpr double kAngle = 50.0 * kRadians;

std::vector<Camera> wide_cameras() {
  return {make_camera(Intrinsics<Ds>{{380.8, 380.9, 510.3, 514.3, 0.56, -0.24}}, {1024, 1024}),
          make_camera(Intrinsics<Kb4>{{190.9, 190.8, 254.9, 256.9, 0.0034, 0.0007, -0.002, 0.0002}}, {512, 512}),
          make_camera(Intrinsics<Eucm>{{460.8, 459.5, 365.9, 249.3, 0.6, 1.1}}, {752, 480})};
}

/// Means over other pixels differ by some per cent.
constexpr double kOtherPixels = 1.3;

TEST(LeastRms, NoFitIsBetter) {
  int whole = 0;
  for (const Camera& camera : wide_cameras()) {
    for (const char* model : {"pinhole", "radtan"}) {
      for (const double angle : {10.0 * kRadians, kAngle}) {
        ConvertOptions options;
        options.model = model;
        options.max_angle_rad = angle;
        Diagnostics diagnostics;
        const std::optional<Conversion> fit = convert(camera, options, diagnostics);
        ASSERT_TRUE(fit);
        const std::optional<double> least = least_rms_px(camera, model, angle);
        ASSERT_TRUE(least);
        EXPECT_GT(*least, 0.0);
        // A cone is fitted where the whole is off by more than a pixel.
        const double reached_px =
            fit->report.angle_reduced ? std::numeric_limits<double>::infinity() : fit->report.statistics.error.rms;
        whole += fit->report.angle_reduced ? 0 : 1;
        EXPECT_LE(*least, kOtherPixels * reached_px) << model << " from " << fit->report.from_model << " " << angle;
      }
    }
  }
  EXPECT_GE(whole, 6);
}

TEST(LeastRms, OfAPinholeIsNearlyThatOfItsFit) {
  // tan(t) = t + t^3 / 3 + 2 t^5 / 15 + ...
  const Camera camera = make_camera(Intrinsics<Kb4>{{600.0, 600.0, 319.5, 239.5, 0.33, 0.13, 0.05, 0.02}}, {640, 480});
  ConvertOptions options;
  options.model = "pinhole";
  Diagnostics diagnostics;
  const std::optional<Conversion> fit = convert(camera, options, diagnostics);
  const std::optional<double> least = least_rms_px(camera, "pinhole", options.max_angle_rad);
  ASSERT_TRUE(fit && least);
  EXPECT_FALSE(fit->report.angle_reduced);
  EXPECT_GT(kOtherPixels * *least, fit->report.statistics.error.rms);
}

TEST(LeastRms, IsNothingOfACameraOfTheModel) {
  const Camera camera =
      make_camera(Intrinsics<Radtan>{{458.6, 457.2, 367.2, 248.4, -0.2834, 0.0739, 0.0002, 0.00002, 0.01}}, {752, 480});
  const std::optional<double> least = least_rms_px(camera, "radtan", std::nullopt);
  ASSERT_TRUE(least);
  EXPECT_LT(*least, 1e-8);
  const std::optional<double> of_fisheye = least_rms_px(wide_cameras()[1], "kb4", std::nullopt);
  ASSERT_TRUE(of_fisheye);
  EXPECT_LT(*of_fisheye, 1e-8);
}

TEST(LeastRms, IsNotKnownOfOtherModelsAndBehindTheCamera) {
  const Camera camera = wide_cameras()[1];
  EXPECT_EQ(least_rms_px(camera, "mei", kAngle), std::nullopt);
  EXPECT_EQ(least_rms_px(camera, "rational", kAngle), std::nullopt);
  EXPECT_EQ(least_rms_px(camera, "no-such-model", kAngle), std::nullopt);
  EXPECT_EQ(least_rms_px(camera, "radtan", std::nullopt), std::nullopt);
  Camera without_size = camera;
  without_size.image_size.reset();
  EXPECT_EQ(least_rms_px(without_size, "radtan", kAngle), std::nullopt);
}

}  // namespace
}  // namespace fca::test
