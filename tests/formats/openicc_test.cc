// SPDX-License-Identifier: BSD-3-Clause
// OpenImuCameraCalibrator's JSON, by numbers of its program's formulas worked out by hand.
#include "formats/test_files.h"

#include <fca/code.h>

#include <array>
#include <cmath>

namespace fca::test {
namespace {

std::string good(const std::string& name) { return read_file(testdata_dir() / "openicc/good" / name); }

const Camera& only(const Calibration& calibration) { return calibration.rig.cameras.at(0); }

TEST(Openicc, TheSecondFocalLengthIsTheFirstTimesTheAspectRatio) {
  const Calibration calibration = calibration_of(good("fisheye.json"), "lens.json");
  const Camera& camera = only(calibration);
  EXPECT_EQ(model_info(camera.model).id, "kb4");
  EXPECT_EQ(parameter(camera.model, "fx"), 850.5);
  EXPECT_EQ(parameter(camera.model, "fy"), 850.5 * 1.0025);
  EXPECT_EQ(parameter(camera.model, "k4"), -0.0025);
  EXPECT_EQ(camera.image_size, (ImageSize{1920, 1080}));
  EXPECT_EQ(camera.frame_rate_hz, 59.9375);
}

TEST(Openicc, EveryModelOfTheProgramIsRead) {
  for (const auto& [name, model] : {std::pair{"radial-tangential.json", "radtan"},
                                    {"double-sphere.json", "ds"},
                                    {"extended-unified.json", "eucm"},
                                    {"division.json", "division"},
                                    {"pinhole.json", "pinhole"},
                                    {"umi-pinhole.json", "pinhole"},
                                    {"perspective.json", "radtan"},
                                    {"skew.json", "kb4-skew"}}) {
    EXPECT_EQ(model_info(only(calibration_of(good(name), name)).model).id, model) << name;
  }
}

// r_u = r_d / (1 + k r_d^2), both in pixels: the pixel 400 px right of the centre, k = -2.5e-7, is at 400 / 0.96.
TEST(Openicc, TheDivisionModelCountsPixels) {
  const Calibration calibration = calibration_of(good("division.json"), "lens.json");
  const Camera& camera = only(calibration);
  const Ray ray = {400.0 / 0.96 / 850.5, 0.0, 1.0};
  const std::optional<Pixel> pixel = project(camera.model, ray);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR((*pixel)[0], 961.25 + 400.0, 1e-9);
  EXPECT_NEAR((*pixel)[1], 538.75, 1e-9);
}

TEST(Openicc, SkewShearsTheRows) {
  const Calibration straight = calibration_of(good("fisheye.json"), "lens.json");
  const Calibration skewed = calibration_of(good("skew.json"), "lens.json");
  const Ray ray = {0.1, 0.3, 1.0};
  const Pixel a = project(only(straight).model, ray).value();
  const Pixel b = project(only(skewed).model, ray).value();
  EXPECT_NEAR(b[1], a[1], 1e-12);
  EXPECT_NEAR(b[0] - a[0], 0.5 * (a[1] - 538.75) / (850.5 * 1.0025), 1e-12) << "u = fx x + skew y + cx";
}

// q = (w 0.5, -0.5, 0.5, -0.5) takes x to -y, y to -z, z to x: the camera's axis is the IMU's x.
TEST(Openicc, ThePoseIsTheCamerasInTheImu) {
  const Calibration calibration = calibration_of(good("fisheye-with-pose.json"), "lens.json");
  const Transform* T_imu_cam = calibration.rig.stated("imu0", "cam0");
  ASSERT_NE(T_imu_cam, nullptr);
  EXPECT_EQ((*T_imu_cam)(0, 2), 1.0);
  EXPECT_EQ((*T_imu_cam)(1, 0), -1.0);
  EXPECT_EQ((*T_imu_cam)(2, 1), -1.0);
  EXPECT_EQ((*T_imu_cam)(2, 3), 0.0125);
  EXPECT_EQ(calibration.rig.kind_of("imu0"), FrameKind::kImu);
}

/// The lens and the result, in that order or the other.
Calibration joined(const char* first, const char* second) {
  Diagnostics diagnostics;
  std::optional<Calibration> calibration =
      read_calibration({document_of(good(first), first), document_of(good(second), second)}, nullptr, {}, diagnostics);
  EXPECT_TRUE(calibration) << first;
  return calibration ? *std::move(calibration) : Calibration();
}

// t_cam = t_imu + offset, and ours is t_imu = t_cam + offset.
TEST(Openicc, TheTimeOffsetHasTheOtherSign) {
  for (const Calibration& calibration :
       {joined("fisheye.json", "imu-result.json"), joined("imu-result.json", "fisheye.json")}) {
    ASSERT_EQ(calibration.rig.cameras.size(), 1U);
    EXPECT_EQ(only(calibration).time_offset_s, 0.0125);
    EXPECT_NE(calibration.rig.stated("imu0", "cam0"), nullptr);
    EXPECT_EQ(calibration.rig.find_extra_field("imu0", "time_offset_imu_to_cam_s"), nullptr);
  }
  const std::string alone = with_replaced(good("fisheye.json"), "\"fps\"", "\"time_offset_imu_to_cam_s\": 0.25, \"fps\"");
  EXPECT_EQ(only(calibration_of(alone, "lens.json")).time_offset_s, -0.25);
}

TEST(Openicc, AResultAloneHasNoCamera) {
  const Calibration calibration = calibration_of(good("imu-result.json"), "result.json");
  EXPECT_TRUE(calibration.rig.cameras.empty());
  EXPECT_EQ(calibration.rig.poses.size(), 1U);
  EXPECT_EQ(calibration.rig.find_extra_field("", "trajectory"), nullptr) << "thousands of samples";
  EXPECT_NE(calibration.rig.find_extra_field("", "calib_line_delay_us"), nullptr);
}

}  // namespace
}  // namespace fca::test
