// SPDX-License-Identifier: BSD-3-Clause
// A rectification is OpenCV's to rounding, and does what one is for: matches lie in one row.
#include "lib/convert/known_cameras.h"

#include <fca/code.h>
#include <fca/rectify/rectify.h>
#include <fca/rectify/vertical_disparity.h>
#include <fca/rig/rotation.h>

#include <opencv2/calib3d.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fca {
namespace {

using test::kRadians;

constexpr ImageSize kSize = {752, 480};

Camera radtan(const std::string& name, std::array<double, 4> k) {
  Camera camera =
      test::make_camera(Intrinsics<Radtan>{{458.654, 457.296, 367.215, 248.375, k[0], k[1], k[2], k[3], 0.0}}, kSize);
  camera.name = name;
  return camera;
}

Camera fisheye(const std::string& name) {
  Camera camera =
      test::make_camera(Intrinsics<Kb4>{{190.98, 190.97, 254.93, 256.9, 0.0034, 0.0007, -0.002, 0.0002}}, {512, 512});
  camera.name = name;
  return camera;
}

/// Turned by up to `angle_rad` about any axis, the baseline within that of an axis of the image.
Transform random_pose(std::mt19937& random, double angle_rad, bool is_vertical) {
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  const std::array<double, 3> axis = {one(random), one(random), one(random)};
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  const double half = 0.5 * angle_rad * (0.1 + 0.45 * (1.0 + one(random)));
  const double s = std::sin(half) / length;
  std::array<double, 3> t = {1.0, 0.3 * one(random), 0.3 * one(random)};
  if (is_vertical) std::swap(t[0], t[1]);
  const double metres = 0.11 * (one(random) < 0.0 ? -1.0 : 1.0);
  return pose_of(Quaternion{s * axis[0], s * axis[1], s * axis[2], std::cos(half)},
                 {metres * t[0], metres * t[1], metres * t[2]});
}

cv::Matx33d rotation_of(const Transform& T) {
  return {T(0, 0), T(0, 1), T(0, 2), T(1, 0), T(1, 1), T(1, 2), T(2, 0), T(2, 1), T(2, 2)};
}
cv::Vec3d translation_of_cv(const Transform& T) { return {T(0, 3), T(1, 3), T(2, 3)}; }

double difference(const Transform& ours, const cv::Matx33d& theirs) {
  return cv::norm(rotation_of(ours) - theirs, cv::NORM_INF);
}

struct OfOpenCv {
  cv::Matx33d R1, R2;
  cv::Matx34d P1, P2;
  std::array<cv::Rect, 2> valid;
};

OfOpenCv stereo_rectify(const Camera& first, const Camera& second, const Transform& T, double alpha,
                        const cv::Size& new_size = {}) {
  const auto matrix = [](const Camera& camera) {
    const auto k = parameter_values(camera.model);
    return cv::Matx33d(k[0], 0, k[2], 0, k[1], k[3], 0, 0, 1);
  };
  const auto lens = [](const Camera& camera) {
    const auto k = parameter_values(camera.model);
    return cv::Vec<double, 5>(k[4], k[5], k[6], k[7], k[8]);
  };
  OfOpenCv result;
  cv::Matx44d Q;
  cv::stereoRectify(matrix(first), lens(first), matrix(second), lens(second),
                    {first.image_size->width, first.image_size->height}, rotation_of(T), translation_of_cv(T), result.R1,
                    result.R2, result.P1, result.P2, Q, cv::CALIB_ZERO_DISPARITY, alpha, new_size, &result.valid[0],
                    &result.valid[1]);
  return result;
}

TEST(Rectify, RotationsAreOpenCvs) {
  std::mt19937 random(28);
  const Camera first = radtan("left", {-0.28, 0.07, 2e-4, 2e-5});
  const Camera second = radtan("right", {-0.29, 0.08, -1e-4, 3e-5});
  for (const bool is_vertical : {false, true}) {
    for (int i = 0; i < 200; ++i) {
      const Transform T = random_pose(random, 20 * kRadians, is_vertical);
      const std::optional<RectifyingRotations> ours = rectifying_rotations(T);
      ASSERT_TRUE(ours);
      const OfOpenCv theirs = stereo_rectify(first, second, T, -1);
      EXPECT_LE(difference(ours->T_rectified_camera[0], theirs.R1), 1e-12);
      EXPECT_LE(difference(ours->T_rectified_camera[1], theirs.R2), 1e-12);
      EXPECT_EQ(ours->is_vertical, theirs.P2(1, 3) != 0.0);
      const double product = ours->is_vertical ? theirs.P2(1, 3) / theirs.P2(1, 1) : theirs.P2(0, 3) / theirs.P2(0, 0);
      EXPECT_NEAR(ours->offset_m, -product, 1e-12);
    }
  }
}

TEST(Rectify, RotationsOfFisheyesAreOpenCvs) {
  std::mt19937 random(29);
  const cv::Matx33d K(190.98, 0, 254.93, 0, 190.97, 256.9, 0, 0, 1);
  const cv::Vec4d D(0.0034, 0.0007, -0.002, 0.0002);
  for (int i = 0; i < 200; ++i) {
    const Transform T = random_pose(random, 20 * kRadians, false);
    const std::optional<RectifyingRotations> ours = rectifying_rotations(T);
    ASSERT_TRUE(ours);
    cv::Matx33d R1;
    cv::Matx33d R2;
    cv::Matx34d P1;
    cv::Matx34d P2;
    cv::Matx44d Q;
    cv::fisheye::stereoRectify(K, D, K, D, {512, 512}, cv::Mat(rotation_of(T)), translation_of_cv(T), R1, R2, P1, P2, Q,
                               cv::CALIB_ZERO_DISPARITY);
    EXPECT_LE(difference(ours->T_rectified_camera[0], R1), 1e-12);
    EXPECT_LE(difference(ours->T_rectified_camera[1], R2), 1e-12);
  }
}

// OpenCV undistorts the corners in five steps, which are enough for lenses of little distortion, and borders at nine points
// each.
TEST(Rectify, TheCommonCameraIsNearOpenCvs) {
  std::mt19937 random(30);
  const Camera first = radtan("left", {-0.1, 0.02, 2e-4, 2e-5});
  const Camera second = radtan("right", {-0.11, 0.02, -1e-4, 3e-5});
  for (const double alpha : {0.0, 0.5, 1.0}) {
    for (const ImageSize size : {kSize, ImageSize{640, 400}}) {
      Transform T = random_pose(random, 2 * kRadians, false);
      T(0, 3) = -0.11;
      T(1, 3) = 0.002;
      T(2, 3) = -0.003;
      Diagnostics diagnostics;
      const std::optional<RectifiedPair> ours = rectify(first, second, T, {RectifiedByAlpha{alpha}, size}, diagnostics);
      ASSERT_TRUE(ours);
      const OfOpenCv theirs = stereo_rectify(first, second, T, alpha, {size.width, size.height});
      EXPECT_NEAR(ours->focal_lengths[0], theirs.P1(0, 0), 0.5);
      EXPECT_NEAR(ours->views[0].centre[0], theirs.P1(0, 2), 0.5);
      EXPECT_NEAR(ours->views[0].centre[1], theirs.P1(1, 2), 0.5);
    }
  }
}

/// Which of the rectified image's pixels a camera sees, by its model alone.
bool sees_all(const Camera& camera, const RectifiedPair& pair, std::size_t view, const ImageRegion& part) {
  const Camera rectified = rectified_camera(pair, view, *pair.size);
  const Transform back = *inverse(pair.views.at(view).T_rectified_camera);
  for (int v = part.y; v < part.y + part.size.height; ++v) {
    for (int u = part.x; u < part.x + part.size.width; ++u) {
      const std::optional<Ray> ray = unproject(rectified.model, {static_cast<double>(u), static_cast<double>(v)});
      const std::optional<Pixel> pixel = project(camera.model, rotated(back, *ray));
      if (!pixel || !camera.image_size->holds(*pixel)) return false;
    }
  }
  return true;
}

TEST(Rectify, AlphaZeroShowsSeenPixelsAlone) {
  std::mt19937 random(31);
  const std::array<Camera, 2> cameras = {radtan("left", {-0.28, 0.07, 2e-4, 2e-5}),
                                         radtan("right", {-0.29, 0.08, -1e-4, 3e-5})};
  for (int i = 0; i < 5; ++i) {
    Diagnostics diagnostics;
    const std::optional<RectifiedPair> pair =
        rectify(cameras[0], cameras[1], random_pose(random, 3 * kRadians, i % 2 == 1), {}, diagnostics);
    ASSERT_TRUE(pair);
    for (std::size_t view = 0; view < 2; ++view) {
      const ImageRegion& valid = *pair->views.at(view).valid;
      EXPECT_TRUE(sees_all(cameras.at(view), *pair, view, valid));
      EXPECT_GE(valid.size.width, kSize.width - 2);
      EXPECT_GE(valid.size.height, kSize.height - 2);
    }
  }
}

TEST(Rectify, TheValidRegionOfAWideViewIsSeen) {
  const std::array<Camera, 2> cameras = {radtan("left", {-0.28, 0.07, 2e-4, 2e-5}),
                                         radtan("right", {-0.29, 0.08, -1e-4, 3e-5})};
  std::mt19937 random(32);
  Diagnostics diagnostics;
  const Transform T = random_pose(random, 3 * kRadians, false);
  const std::optional<RectifiedPair> pair = rectify(cameras[0], cameras[1], T, {RectifiedByAlpha{1.0}}, diagnostics);
  ASSERT_TRUE(pair);
  const OfOpenCv theirs = stereo_rectify(cameras[0], cameras[1], T, 1.0);
  for (std::size_t view = 0; view < 2; ++view) {
    const ImageRegion& valid = *pair->views.at(view).valid;
    EXPECT_TRUE(sees_all(cameras.at(view), *pair, view, valid));
    EXPECT_FALSE(sees_all(cameras.at(view), *pair, view, {0, 0, *pair->size}));
    EXPECT_GE(valid.size.width * valid.size.height, 0.97 * theirs.valid.at(view).area());
  }
}

TEST(Rectify, MatchesLieInOneRow) {
  std::mt19937 random(33);
  for (const bool is_vertical : {false, true}) {
    for (const bool wide : {false, true}) {
      const Camera first = wide ? fisheye("left") : radtan("left", {-0.28, 0.07, 2e-4, 2e-5});
      const Camera second = wide ? fisheye("right") : radtan("right", {-0.29, 0.08, -1e-4, 3e-5});
      const Transform T = random_pose(random, 5 * kRadians, is_vertical);
      Diagnostics diagnostics;
      const std::optional<RectifiedPair> pair = rectify(first, second, T, {}, diagnostics);
      ASSERT_TRUE(pair);
      const std::optional<VerticalDisparity> left =
          vertical_disparity({first, first.model}, {second, second.model}, T, *pair, *pair->size);
      ASSERT_TRUE(left);
      EXPECT_LE(left->at_infinity.max_px, 1e-9);
      EXPECT_LE(left->at_ten_baselines.max_px, 1e-9);
      EXPECT_GT(left->at_ten_baselines.share, 0.3);
    }
  }
}

// A second camera that is rolled by a small angle more than the rectification knows: row differences grow with the column.
TEST(Rectify, ARollShowsInTheRows) {
  const Camera camera = radtan("left", {0, 0, 0, 0});
  Transform T;
  T(0, 3) = -0.1;
  Diagnostics diagnostics;
  const std::optional<RectifiedPair> pair = rectify(camera, camera, T, {RectifiedByAlpha{0.0}}, diagnostics);
  ASSERT_TRUE(pair);
  constexpr double kRoll = 1e-3;
  Transform rolled = T;
  rolled(0, 0) = rolled(1, 1) = std::cos(kRoll);
  rolled(1, 0) = std::sin(kRoll);
  rolled(0, 1) = -std::sin(kRoll);
  const std::optional<VerticalDisparity> left =
      vertical_disparity({camera, camera.model}, {camera, camera.model}, rolled, *pair, *pair->size);
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->at_infinity.max_px, kRoll * 0.5 * kSize.width, 0.15 * kRoll * kSize.width);
}

TEST(Rectify, TheRectificationStatesThePose) {
  std::mt19937 random(34);
  const Camera first = radtan("left", {-0.28, 0.07, 2e-4, 2e-5});
  const Camera second = radtan("right", {-0.29, 0.08, -1e-4, 3e-5});
  const Transform T = random_pose(random, 5 * kRadians, false);
  Diagnostics diagnostics;
  const std::optional<RectifiedPair> pair = rectify(first, second, T, {}, diagnostics);
  ASSERT_TRUE(pair);
  EXPECT_LE(largest_difference(pose_of(*pair), T).distance, 1e-14);
  EXPECT_LE(distance_between(pose_of(*pair), T), 1e-14);
  const std::optional<RectifiedPair> back = rectify(second, first, *inverse(T), {}, diagnostics);
  ASSERT_TRUE(back);
  for (std::size_t i = 0; i < 2; ++i) {
    const Transform& here = exchanged(*back).views.at(i).T_rectified_camera;
    EXPECT_LE(largest_difference(here, pair->views.at(i).T_rectified_camera).distance, 1e-14);
  }
}

void expect_refused(const Camera& first, const Camera& second, const Transform& T, const RectifyOptions& options, Code code) {
  Diagnostics diagnostics;
  EXPECT_FALSE(rectify(first, second, T, options, diagnostics));
  EXPECT_TRUE(std::ranges::any_of(diagnostics.entries(), [&](const Diagnostic& entry) { return entry.facts.code == code; }));
}

TEST(Rectify, RefusesWhatIsNoPair) {
  const Camera camera = radtan("left", {-0.28, 0.07, 2e-4, 2e-5});
  Transform beside;
  beside(0, 3) = -0.1;
  expect_refused(camera, fisheye("right"), beside, {}, Code::kRectifySizesDiffer);
  expect_refused(camera, camera, {}, {}, Code::kRectifyNoBaseline);
  Camera without = camera;
  without.image_size.reset();
  expect_refused(camera, without, beside, {}, Code::kCameraWithoutSize);
  expect_refused(fisheye("left"), fisheye("right"), beside, {RectifiedByField{121 * kRadians}}, Code::kRectifyViewTooWide);
  expect_refused(fisheye("left"), fisheye("right"), beside, {RectifiedByAlpha{1.0}}, Code::kRectifyNoValidPart);
}

TEST(Rectify, AFieldOfViewIsAcrossTheWidth) {
  Transform beside;
  beside(0, 3) = -0.1;
  Diagnostics diagnostics;
  const std::optional<RectifiedPair> pair =
      rectify(fisheye("left"), fisheye("right"), beside, {RectifiedByField{100 * kRadians}, ImageSize{640, 480}}, diagnostics);
  ASSERT_TRUE(pair);
  EXPECT_NEAR(pair->focal_lengths[0], 320.0 / std::tan(50 * kRadians), 1e-9);
  EXPECT_EQ(pair->focal_lengths[0], pair->focal_lengths[1]);
  EXPECT_EQ(pair->views[0].centre, (Pixel{319.5, 239.5}));
}

}  // namespace
}  // namespace fca
