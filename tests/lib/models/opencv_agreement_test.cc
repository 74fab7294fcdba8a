// SPDX-License-Identifier: BSD-3-Clause
// radtan, rational, opencv14, kb4 and mei are OpenCV's cv::projectPoints, cv::fisheye and cv::omnidir, to 1e-9 px.
#include "model_test_support.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/ccalib/omnidir.hpp>

namespace fca::test {
namespace {

struct PointsAndPixels {
  std::vector<cv::Point3d> points;
  std::vector<Pixel> pixels;
};

/// Rays of all azimuths, of several lengths, up to the smaller of the model's and OpenCV's largest angle, whose pixels are less
/// than 10,000 px from the origin: farther out 1e-9 px is less than the rounding of a double.
template <CameraModelType M>
PointsAndPixels projected_by_us(const TestCamera<M>& camera, double largest_angle) {
  PointsAndPixels result;
  const double last = std::min(largest_angle, M::max_angle(camera.p()) - 1e-6);
  for (const double angle : angles_up_to(last)) {
    for (const double azimuth : some_azimuths()) {
      for (const double length : {0.1, 1.0, 30.0}) {
        const Ray ray = ray_at(angle, azimuth, length);
        Pixel pixel;
        EXPECT_TRUE(M::project(camera.p(), ray.data(), pixel.data())) << angle;
        if (std::hypot(pixel[0], pixel[1]) > 1e4) continue;
        result.points.emplace_back(ray[0], ray[1], ray[2]);
        result.pixels.push_back(pixel);
      }
    }
  }
  return result;
}

void expect_equal(const std::vector<Pixel>& ours, const std::vector<cv::Point2d>& theirs) {
  ASSERT_EQ(ours.size(), theirs.size());
  EXPECT_GT(ours.size(), 500U);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_NEAR(ours[i][0], theirs[i].x, 1e-9) << i;
    EXPECT_NEAR(ours[i][1], theirs[i].y, 1e-9) << i;
  }
}

cv::Matx33d matrix_of(const double* p) { return {p[0], 0, p[2], 0, p[1], p[3], 0, 0, 1}; }
const cv::Vec3d kZero(0, 0, 0);
constexpr double kDegree = std::numbers::pi / 180.0;

TEST(OpenCvAgreement, RadtanIsProjectPoints) {
  for (const TestCamera<Radtan>& camera : cameras_of<Radtan>()) {
    SCOPED_TRACE(camera.name);
    const PointsAndPixels ours = projected_by_us(camera, 85 * kDegree);
    const double* p = camera.p();
    std::vector<cv::Point2d> theirs;
    cv::projectPoints(ours.points, kZero, kZero, matrix_of(p), std::vector<double>(p + 4, p + 9), theirs);
    expect_equal(ours.pixels, theirs);
  }
}

TEST(OpenCvAgreement, RationalIsProjectPoints) {
  for (const TestCamera<Rational>& camera : cameras_of<Rational>()) {
    SCOPED_TRACE(camera.name);
    const PointsAndPixels ours = projected_by_us(camera, 85 * kDegree);
    const double* p = camera.p();
    std::vector<cv::Point2d> theirs;
    cv::projectPoints(ours.points, kZero, kZero, matrix_of(p), std::vector<double>(p + 4, p + 12), theirs);
    expect_equal(ours.pixels, theirs);
  }
}

// With 12 coefficients where nothing is tilted, else with 14.
TEST(OpenCvAgreement, Opencv14IsProjectPoints) {
  for (const TestCamera<Opencv14>& camera : cameras_of<Opencv14>()) {
    SCOPED_TRACE(camera.name);
    const PointsAndPixels ours = projected_by_us(camera, 85 * kDegree);
    const double* p = camera.p();
    const int count = Opencv14::is_tilted(p) ? 14 : 12;
    std::vector<cv::Point2d> theirs;
    cv::projectPoints(ours.points, kZero, kZero, matrix_of(p), std::vector<double>(p + 4, p + 4 + count), theirs);
    expect_equal(ours.pixels, theirs);
  }
}

TEST(OpenCvAgreement, Kb4IsFisheye) {
  for (const TestCamera<Kb4>& camera : cameras_of<Kb4>()) {
    SCOPED_TRACE(camera.name);
    const PointsAndPixels ours = projected_by_us(camera, 80 * kDegree);
    const double* p = camera.p();
    std::vector<cv::Point2d> theirs;
    cv::fisheye::projectPoints(ours.points, theirs, kZero, kZero, matrix_of(p), std::vector<double>(p + 4, p + 8));
    expect_equal(ours.pixels, theirs);
  }
}

// alpha of cv::fisheye is the skew over fx.
TEST(OpenCvAgreement, Kb4WithSkewIsFisheyeWithAlpha) {
  for (const TestCamera<Skewed<Kb4>>& camera : cameras_of<Skewed<Kb4>>()) {
    SCOPED_TRACE(camera.name);
    const PointsAndPixels ours = projected_by_us(camera, 80 * kDegree);
    const double* p = camera.p();
    std::vector<cv::Point2d> theirs;
    cv::fisheye::projectPoints(ours.points, theirs, kZero, kZero, matrix_of(p), std::vector<double>(p + 4, p + 8), p[8] / p[0]);
    expect_equal(ours.pixels, theirs);
  }
}

TEST(OpenCvAgreement, MeiWithSkewIsOmnidirWithIt) {
  for (const TestCamera<Skewed<Mei>>& camera : cameras_of<Skewed<Mei>>()) {
    SCOPED_TRACE(camera.name);
    const double* p = camera.p();
    const PointsAndPixels ours = projected_by_us(camera, std::numbers::pi);
    cv::Matx33d K = matrix_of(p);
    K(0, 1) = p[9];
    std::vector<cv::Point2d> theirs;
    cv::omnidir::projectPoints(ours.points, theirs, kZero, kZero, K, p[4], std::vector<double>(p + 5, p + 9));
    expect_equal(ours.pixels, theirs);
  }
}

TEST(OpenCvAgreement, MeiIsOmnidir) {
  for (const TestCamera<Mei>& camera : cameras_of<Mei>()) {
    SCOPED_TRACE(camera.name);
    const double* p = camera.p();
    const PointsAndPixels ours = projected_by_us(camera, std::numbers::pi);
    std::vector<cv::Point2d> theirs;
    cv::omnidir::projectPoints(ours.points, theirs, kZero, kZero, matrix_of(p), p[4], std::vector<double>(p + 5, p + 9));
    expect_equal(ours.pixels, theirs);
  }
}

}  // namespace
}  // namespace fca::test
