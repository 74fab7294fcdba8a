// SPDX-License-Identifier: BSD-3-Clause
// OpenVINS as a consumer: its two lenses are OpenCV's, its points are floats, and its poses come in either direction.
#include "fca/formats/consumers/consumer.h"

#include <fca/formats/wording.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <opencv2/calib3d.hpp>

namespace fca::consumers {
namespace {

const std::string kPose =
    "  T_cam_imu:\n    - [1.0, 0.0, 0.0, 0.1]\n    - [0.0, 1.0, 0.0, 0.2]\n    - [0.0, 0.0, 1.0, 0.3]\n    - [0.0, 0.0, 0.0, "
    "1.0]\n";

std::string chain(const std::string& distortion, const std::string& pose = kPose) {
  return "%YAML:1.0\ncam0:\n" + pose + "  camera_model: pinhole\n  distortion_coeffs: [0.1, -0.02, 0.003, -0.001]\n" +
         "  distortion_model: " + distortion + "\n  intrinsics: [400.5, 401.5, 320.25, 240.75]\n  resolution: [640, 480]\n";
}

ConsumerView load(const std::string& bytes) { return find_consumer("openvins")->load(bytes, {}); }

TEST(OpenVins, ItsLensesAreOpenCvs) {
  const cv::Matx33d K(400.5, 0, 320.25, 0, 401.5, 240.75, 0, 0, 1);
  const cv::Vec4d D(0.1, -0.02, 0.003, -0.001);
  for (const bool is_fisheye : {true, false}) {
    const ConsumerView view = load(chain(is_fisheye ? "equidistant" : "radtan"));
    ASSERT_EQ(view.cameras.size(), 1U) << sentence_of(view.refusals.front());
    EXPECT_TRUE(view.warnings.empty());
    for (double x = -0.8; x < 0.9; x += 0.1) {
      for (double y = -0.6; y < 0.7; y += 0.1) {
        const std::vector<cv::Point3d> ray = {{2.0 * x, 2.0 * y, 2.0}};
        std::vector<cv::Point2d> expected;
        if (is_fisheye) {
          cv::fisheye::projectPoints(ray, expected, cv::Vec3d(), cv::Vec3d(), K, D);
        } else {
          cv::projectPoints(ray, cv::Vec3d(), cv::Vec3d(), K, D, expected);
        }
        const auto pixel = view.cameras.front().project({ray[0].x, ray[0].y, ray[0].z});
        ASSERT_TRUE(pixel);
        EXPECT_NEAR((*pixel)[0], expected[0].x, 1e-4);
        EXPECT_NEAR((*pixel)[1], expected[0].y, 1e-4);
      }
    }
    EXPECT_FALSE(view.cameras.front().project({0.1, 0.1, -1.0}));
  }
}

TEST(OpenVins, EitherDirectionOfThePose) {
  const ConsumerView view = load(chain("radtan"));
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].a + " " + view.poses[0].b, "cam0 imu0");
  EXPECT_EQ(view.poses[0].T_a_b[7], 0.2);
  std::string other = kPose;
  other.replace(other.find("T_cam_imu"), 9, "T_imu_cam");
  const ConsumerView inverse = load(chain("radtan", other));
  ASSERT_EQ(inverse.poses.size(), 1U);
  EXPECT_EQ(inverse.poses[0].a + " " + inverse.poses[0].b, "imu0 cam0");
  // T_imu_cam comes first where both stand.
  EXPECT_EQ(load(chain("radtan", kPose + other)).poses.at(0).a, "imu0");
}

TEST(OpenVins, WhatItStopsAt) {
  const std::string good = chain("radtan");
  const auto without = [&good](const std::string& part, const std::string& instead) {
    std::string bytes = good;
    return bytes.replace(bytes.find(part), part.size(), instead);
  };
  ASSERT_TRUE(load(good).loads());
  EXPECT_FALSE(load(good.substr(good.find("cam0"))).loads());     // no %YAML
  EXPECT_FALSE(load(without("    - [1.0", "  - [1.0")).loads());  // not indented
  EXPECT_FALSE(load(chain("radtan", "")).loads());
  EXPECT_FALSE(load(without(", 0.003, -0.001]", "]")).loads());  // std::vector::at
  EXPECT_FALSE(load(without("resolution", "size")).loads());
  EXPECT_FALSE(load(without("cam0", "left")).loads());
  for (const std::string& model : {std::string("omni"), std::string("ds")}) {
    const ConsumerView view = load(without("pinhole", model));
    EXPECT_TRUE(view.loads() && view.cameras.at(0).misread) << model;
  }
}

TEST(OpenVins, ImuStandsBelowImu0) {
  const auto load_imu = [](const std::string& bytes) { return find_consumer("openvins-imu")->load(bytes, {}); };
  std::string imu =
      "%YAML:1.0\nimu0:\n  accelerometer_noise_density: 2.0e-3\n  accelerometer_random_walk: 3.0e-3\n"
      "  gyroscope_noise_density: 1.6968e-04\n  gyroscope_random_walk: 1.9393e-05\n  update_rate: 200.0\n";
  EXPECT_FALSE(load_imu(imu).loads());  // since 2.7 it also wants the IMU's own intrinsics
  for (const char* matrix : {"Tw", "Ta", "R_IMUtoACC", "R_IMUtoGYRO", "Tg"})
    imu += std::string("  ") + matrix + ":\n    - [1.0, 0.0, 0.0]\n    - [0.0, 1.0, 0.0]\n    - [0.0, 0.0, 1.0]\n";
  EXPECT_TRUE(load_imu(imu).loads());
  EXPECT_FALSE(load_imu("%YAML:1.0\naccelerometer_noise_density: 2.0e-3\n").loads());
}

}  // namespace
}  // namespace fca::consumers
