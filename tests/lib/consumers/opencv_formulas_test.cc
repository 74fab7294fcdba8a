// SPDX-License-Identifier: BSD-3-Clause
// The formulas of the consumer of OpenCV against OpenCV. Here rather than with the formats, because only the tests of the
// library link calib3d and ccalib.
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/ccalib/omnidir.hpp>
#include <random>
#include <vector>

#include "../formats/consumers/opencv_formulas.h"

namespace fca::consumers::opencv {
namespace {

constexpr double kTolerancePx = 1e-9;
const cv::Vec3d kNoMotion(0.0, 0.0, 0.0);

/// Rays all around, with some on the axis and in the plane z = 0, where the functions have special cases.
std::vector<Ray> rays(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::vector<Ray> result = {{0, 0, 1}, {0, 0, -1}, {0.3, -0.2, 0}, {1e-9, 0, 1}, {0.5, 0.1, 1e-310}};
  for (int i = 0; i < 400; ++i) result.push_back({coordinate(random), coordinate(random), coordinate(random)});
  return result;
}

std::vector<cv::Point3d> points_of(const std::vector<Ray>& rays) {
  std::vector<cv::Point3d> points;
  for (const Ray& ray : rays) points.emplace_back(ray[0], ray[1], ray[2]);
  return points;
}

cv::Matx33d matrix_of(const CameraMatrix& K) { return {K.fx, K.skew, K.cx, 0, K.fy, K.cy, 0, 0, 1}; }

constexpr CameraMatrix kCamera = {420.5, 418.25, 333.0, 251.5, 0.0};
constexpr CameraMatrix kSkewed = {420.5, 418.25, 333.0, 251.5, 1.75};

/// Relative beyond 1000 px: rays near z = 0 land at 1e20.
void expect_same(const std::vector<Ray>& rays, const std::vector<cv::Point2d>& theirs, const auto& ours) {
  ASSERT_EQ(rays.size(), theirs.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Pixel pixel = ours(rays[i]);
    const double scale = std::max({1.0, std::abs(theirs[i].x) / 1000.0, std::abs(theirs[i].y) / 1000.0});
    EXPECT_NEAR(pixel[0], theirs[i].x, kTolerancePx * scale) << rays[i][0] << " " << rays[i][1] << " " << rays[i][2];
    EXPECT_NEAR(pixel[1], theirs[i].y, kTolerancePx * scale) << rays[i][0] << " " << rays[i][1] << " " << rays[i][2];
  }
}

TEST(OpenCvFormulas, ProjectPointsWithEveryNumberOfCoefficients) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coefficient(-0.05, 0.05);
  for (const std::size_t count : {0U, 4U, 5U, 8U, 12U, 14U}) {
    for (const CameraMatrix& K : {kCamera, kSkewed}) {
      PinholeCoefficients k{};
      for (std::size_t i = 0; i < count; ++i) k.at(i) = coefficient(random);
      const std::vector<double> D(k.begin(), k.begin() + static_cast<std::ptrdiff_t>(count));
      std::vector<Ray> all = rays(random);
      // (0.5, 0.1, 1e-310): 1 / z overflows there and here, into inf - inf.
      std::erase_if(all, [](const Ray& ray) { return ray[2] == 1e-310; });
      std::vector<cv::Point2d> theirs;
      cv::projectPoints(points_of(all), kNoMotion, kNoMotion, matrix_of(K), D, theirs);
      expect_same(all, theirs, [&](const Ray& ray) { return project_points(K, k, ray); });
    }
  }
}

TEST(OpenCvFormulas, FisheyeProjectPointsBehindTheCameraToo) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coefficient(-0.02, 0.02);
  for (const CameraMatrix& K : {kCamera, kSkewed}) {
    const std::array<double, 4> k = {coefficient(random), coefficient(random), coefficient(random), coefficient(random)};
    const std::vector<Ray> all = rays(random);
    std::vector<cv::Point2d> theirs;
    cv::fisheye::projectPoints(points_of(all), theirs, kNoMotion, kNoMotion, matrix_of(K), cv::Vec4d(k.data()));
    expect_same(all, theirs, [&](const Ray& ray) { return fisheye_project_points(K, k, ray); });
  }
}

TEST(OpenCvFormulas, OmnidirProjectPointsWithSkew) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coefficient(-0.05, 0.05);
  for (const double xi : {0.0, 0.7, 1.0, 1.6}) {
    for (const CameraMatrix& K : {kCamera, kSkewed}) {
      const std::array<double, 4> k = {coefficient(random), coefficient(random), coefficient(random), coefficient(random)};
      std::vector<Ray> all = rays(random);
      // The pole of xi = 1, and z = 0 of xi = 0: 0 / 0 and x / 0.
      std::erase_if(all, [](const Ray& ray) { return std::abs(ray[2]) < 1e-300 || (ray[0] == 0.0 && ray[2] < 0.0); });
      std::vector<cv::Point2d> theirs;
      cv::omnidir::projectPoints(points_of(all), theirs, kNoMotion, kNoMotion, matrix_of(K), xi, cv::Vec4d(k.data()));
      expect_same(all, theirs, [&](const Ray& ray) { return omnidir_project_points(K, xi, k, ray); });
    }
  }
}

// Also where the iteration has not converged, or never will.
TEST(OpenCvFormulas, UndistortPoints) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const CameraMatrix K = {400.0, 410.0, 320.5, 240.25, 0.0};
  for (int camera = 0; camera < 200; ++camera) {
    PinholeCoefficients k{};
    for (std::size_t i = 0; i < 12; ++i) k.at(i) = unit(random) * (i == 2 || i == 3 || i > 7 ? 0.01 : 0.4);
    const std::vector<cv::Point2d> pixels = {{320.5 + 320.0 * unit(random), 240.25 + 240.0 * unit(random)}};
    std::vector<cv::Point2d> theirs;
    cv::undistortPoints(pixels, theirs, matrix_of(K), std::vector<double>(k.begin(), k.end()));
    const Pixel ours = undistort_point(K, k, {pixels[0].x, pixels[0].y});
    if (!std::isfinite(theirs[0].x) || !std::isfinite(theirs[0].y)) continue;
    const double tolerance = 1e-12 * (1.0 + std::abs(ours[0]) + std::abs(ours[1]));
    EXPECT_NEAR(ours[0], theirs[0].x, tolerance);
    EXPECT_NEAR(ours[1], theirs[0].y, tolerance);
  }
}

TEST(OpenCvFormulas, Rodrigues) {
  for (const cv::Vec3d& om :
       {cv::Vec3d(0, 0, 0), cv::Vec3d(0.1, -0.2, 0.3), cv::Vec3d(2.0, 1.0, -1.5), cv::Vec3d(1e-17, 0, 0)}) {
    cv::Matx33d theirs;
    cv::Rodrigues(om, theirs);
    const Matrix3 ours = rotation_of({om[0], om[1], om[2]});
    for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours.at(i), theirs.val[i], 1e-15);
  }
}

// Of matrices that are nearly rotations, too, and of turns that it does not notice.
TEST(OpenCvFormulas, RodriguesThereAndBack) {
  const double small = 3e-6;
  for (const cv::Matx33d& matrix :
       {cv::Matx33d(1, 0, 0, 0, 1, 0, 0, 0, 1), cv::Matx33d(0.9998, -0.02, 0, 0.02, 0.9998, 0, 0, 0, 1),
        cv::Matx33d(0.9, 0.1, 0, -0.2, 1.1, 0.3, 0.1, -0.3, 0.8), cv::Matx33d(1, 0, small, 0, 1, 0, -small, 0, 1),
        cv::Matx33d(0, 0, 1, 1, 0, 0, 0, 1, 0), cv::Matx33d(2, 0, 0, 0, 2, 0, 0, 0, 2)}) {
    cv::Vec3d vector;
    cv::Matx33d theirs;
    cv::Rodrigues(matrix, vector);
    cv::Rodrigues(vector, theirs);
    Matrix3 given{};
    std::copy(std::begin(matrix.val), std::end(matrix.val), given.begin());
    const Matrix3 ours = rotation_there_and_back(given);
    for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours.at(i), theirs.val[i], 1e-14) << matrix;
  }
}

}  // namespace
}  // namespace fca::consumers::opencv
