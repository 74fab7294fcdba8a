// SPDX-License-Identifier: BSD-3-Clause
// A map says of each pixel what the models say, and what OpenCV's own maps say of the models that OpenCV has.
#include "lib/convert/known_cameras.h"

#include <fca/convert/convert.h>
#include <fca/remap/image_map.h>
#include <fca/remap/view.h>
#include <fca/rig/rotation.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/ccalib/omnidir.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fca {
namespace {

using test::kRadians;

ImageMap map_between(const Camera& source, const Camera& target, const Transform& turn = {},
                     std::optional<double> limit_rad = {}) {
  Diagnostics diagnostics;
  const std::optional<ImageMapper> mapper = ImageMapper::between(source, target, turn, limit_rad, diagnostics);
  EXPECT_TRUE(mapper.has_value());
  return mapper ? image_map(*mapper) : ImageMap{};
}

Camera pinhole(const ImageSize& size, double full_fov_deg) {
  return test::make_camera(pinhole_of_view(size, full_fov_deg * kRadians), size);
}

/// One pixel at a time, by the models.
std::optional<Pixel> looked_up(const Camera& source, const Camera& target, const Transform& turn, double limit_rad,
                               const Pixel& pixel) {
  const std::optional<Ray> ray = unproject(target.model, pixel);
  if (!ray) return std::nullopt;
  const Ray there = rotated(turn, *ray);
  return angle_from_axis(there) <= limit_rad ? project(source.model, there) : std::nullopt;
}

void expect_as_the_models_say(const Camera& source, const Camera& target, const Transform& turn, double limit_rad) {
  const ImageMap map = map_between(source, target, turn, limit_rad);
  ASSERT_EQ(map.size, *target.image_size);
  double worst = 0.0;
  int differently_seen = 0;
  int there = 0;
  for (std::size_t i = 0; i < map.uv.size() / 2; ++i) {
    const auto column = static_cast<double>(i % static_cast<std::size_t>(map.size.width));
    const std::size_t whole_rows = i / static_cast<std::size_t>(map.size.width);
    const auto row = static_cast<double>(whole_rows);
    const std::optional<Pixel> expected = looked_up(source, target, turn, limit_rad, {column, row});
    const bool found = std::isfinite(map.uv[2 * i]) && std::isfinite(map.uv[2 * i + 1]);
    differently_seen += expected.has_value() != found ? 1 : 0;
    if (!expected || !found) continue;
    ++there;
    for (std::size_t axis : {0U, 1U}) {
      const auto rounding = static_cast<double>(std::numeric_limits<float>::epsilon()) * std::abs((*expected)[axis]);
      worst = std::max(worst, std::abs(static_cast<double>(map.uv[2 * i + axis]) - (*expected)[axis]) - rounding);
    }
  }
  EXPECT_LE(worst, 1e-9) << "px";
  EXPECT_EQ(differently_seen, 0);
  EXPECT_GT(there, 0);
}

/// COLMAP's EQUIRECTANGULAR (half a pixel to the lower right of ours): where the image shows a ray.
Pixel colmap_equirectangular(const ImageSize& size, const Ray& ray) {
  const auto [x, y, z] = ray;
  return {(std::atan2(x, z) / (2.0 * std::numbers::pi) + 0.5) * size.width,
          (0.5 - std::atan2(-y, std::hypot(x, z)) / std::numbers::pi) * size.height};
}

TEST(ImageMap, ShowsAllDirectionsAsColmapDoes) {
  const ImageSize size = {200, 101};
  const Transform turn = turned(25 * kRadians, -12 * kRadians, 8 * kRadians);
  for (const Camera& source : {test::tumvi(), test::kalibr_radtan(), test::lens_220(), test::ocamcalib_sample()}) {
    Diagnostics diagnostics;
    const auto mapper = ImageMapper::to_equirectangular(source, size, turn, {}, diagnostics);
    ASSERT_TRUE(mapper);
    const ImageMap map = image_map(*mapper);
    ASSERT_EQ(map.size, size);
    int there = 0;
    for (int row = 0; row < size.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        const Pixel pixel = {static_cast<double>(column), static_cast<double>(row)};
        const Ray ray = equirectangular_ray(size, pixel);
        const Pixel half_off = colmap_equirectangular(size, ray);
        ASSERT_NEAR(half_off[0], pixel[0] + 0.5, 1e-9);
        ASSERT_NEAR(half_off[1], pixel[1] + 0.5, 1e-9);
        const std::optional<Pixel> expected = project(source.model, rotated(turn, ray));
        const std::size_t at = 2 * static_cast<std::size_t>(row * size.width + column);
        ASSERT_EQ(std::isfinite(map.uv[at]), expected.has_value()) << row << " " << column;
        if (!expected) continue;
        ++there;
        const double rounding = 1e-7 * (1.0 + std::hypot((*expected)[0], (*expected)[1]));
        EXPECT_NEAR(map.uv[at], (*expected)[0], rounding);
        EXPECT_NEAR(map.uv[at + 1], (*expected)[1], rounding);
      }
    }
    EXPECT_GT(there, 100);
  }
}

TEST(ImageMap, IsWhatTheModelsSayOfEveryPixel) {
  const std::array sources = {test::kalibr_radtan(), test::kalibr_ds(), test::kalibr_eucm(),      test::tumvi(),
                              test::tumvi_ds(),      test::lens_220(),  test::ocamcalib_sample(), test::woodscape_front(),
                              test::rational_lens()};
  const Transform turn = turned(25 * kRadians, -12 * kRadians, 8 * kRadians);
  for (const Camera& source : sources) {
    SCOPED_TRACE(model_info(source.model).id);
    expect_as_the_models_say(source, pinhole({160, 120}, 100), {}, std::numbers::pi);
    expect_as_the_models_say(source, pinhole({160, 120}, 170), turn, std::numbers::pi);
    expect_as_the_models_say(source, test::tumvi(), turn, 60 * kRadians);  // with rays behind the camera
  }
  for (const Camera& target : sources) {
    SCOPED_TRACE(model_info(target.model).id);
    Camera smaller = target;
    smaller.image_size = ImageSize{target.image_size->width, 40};
    expect_as_the_models_say(test::lens_220(), smaller, turn, std::numbers::pi);
  }
}

// Every model, as the fit of one lens.
TEST(ImageMap, KnowsEveryModel) {
  for (const ModelInfo& info : all_models()) {
    SCOPED_TRACE(info.id);
    Diagnostics diagnostics;
    ConvertOptions options;
    options.model = info.id;
    options.bound = false;
    const std::optional<Conversion> fitted = convert(test::euroc(), options, diagnostics);
    ASSERT_TRUE(fitted.has_value());
    expect_as_the_models_say(fitted->camera, pinhole({300, 200}, 120), turned(0.3, 0.0, 0.1), std::numbers::pi);
    expect_as_the_models_say(test::tumvi(), fitted->camera, {}, std::numbers::pi);
  }
}

cv::Matx33d matrix_of(const CameraModel& model) {
  const std::span<const double> p = parameter_values(model);
  return {p[0], 0, p[2], 0, p[1], p[3], 0, 0, 1};
}

cv::Matx33d matrix_of(const Transform& T) {
  return {T(0, 0), T(0, 1), T(0, 2), T(1, 0), T(1, 1), T(1, 2), T(2, 0), T(2, 1), T(2, 2)};
}

void expect_same_map(const ImageMap& ours, const cv::Mat& theirs) {
  ASSERT_EQ(theirs.type(), CV_32FC2);
  ASSERT_EQ(theirs.total(), ours.uv.size() / 2);
  double worst = 0.0;
  for (std::size_t i = 0; i < ours.uv.size(); ++i) {
    ASSERT_TRUE(std::isfinite(ours.uv[i])) << i;
    ASSERT_TRUE(std::isfinite(theirs.ptr<float>()[i])) << i;
    worst = std::max(worst, static_cast<double>(std::abs(ours.uv[i] - theirs.ptr<float>()[i])));
  }
  EXPECT_LE(worst, 1e-4) << "px";
}

/// OpenCV's R takes the source's rays to the target's.
const Transform kTurn = turned(4 * kRadians, -3 * kRadians, 7 * kRadians);

TEST(ImageMap, IsThatOfInitUndistortRectifyMap) {
  for (const Camera& source : {test::euroc(), test::kalibr_radtan(), test::rational_lens()}) {
    SCOPED_TRACE(model_info(source.model).id);
    const Camera target = pinhole(*source.image_size, 70);
    const std::span<const double> p = parameter_values(source.model);
    // Both k1 k2 p1 p2 k3 (k4 k5 k6), OpenCV's order.
    const std::vector<double> k(p.begin() + 4, p.end());
    for (const Transform& turn : {Transform(), kTurn}) {
      cv::Mat theirs;
      cv::Mat none;
      cv::initUndistortRectifyMap(matrix_of(source.model), k, matrix_of(turn).t(), matrix_of(target.model),
                                  {target.image_size->width, target.image_size->height}, CV_32FC2, theirs, none);
      expect_same_map(map_between(source, target, turn), theirs);
    }
  }
}

TEST(ImageMap, IsThatOfOpenCvsFisheye) {
  for (const Camera& source : {test::tumvi(), test::kalibr_kb4(), test::t265_like()}) {
    const Camera target = pinhole(*source.image_size, 120);
    const std::span<const double> p = parameter_values(source.model);
    for (const Transform& turn : {Transform(), kTurn}) {
      cv::Mat u;
      cv::Mat v;
      cv::fisheye::initUndistortRectifyMap(matrix_of(source.model), std::vector<double>(p.begin() + 4, p.end()),
                                           matrix_of(turn).t(), matrix_of(target.model),
                                           {target.image_size->width, target.image_size->height}, CV_32FC1, u, v);
      cv::Mat theirs;
      cv::merge(std::vector<cv::Mat>{u, v}, theirs);
      expect_same_map(map_between(source, target, turn), theirs);
    }
  }
}

TEST(ImageMap, TurnsAsItSays) {
  const auto axis_after = [](double yaw, double pitch, double roll) {
    return rotated(turned(yaw * kRadians, pitch * kRadians, roll * kRadians), {0.0, 0.0, 1.0});
  };
  EXPECT_GT(axis_after(10, 0, 0)[0], 0.1) << "to the right";
  EXPECT_LT(axis_after(0, 10, 0)[1], -0.1) << "up";
  EXPECT_NEAR(axis_after(0, 0, 10)[2], 1.0, 1e-12);
  // Clockwise: what was to the right of the camera is then up to the right, in its image.
  const Ray right = rotated(turned(0, 0, 10 * kRadians), {1.0, 0.0, 0.0});
  EXPECT_GT(right[1], 0.1) << "the new camera's right is the old one's right and down";
  // First yaw, then pitch about the new axis: a camera that has turned to the right by 90 degrees looks up from there.
  const Ray both = axis_after(90, 45, 0);
  EXPECT_NEAR(both[0], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(both[1], -std::sqrt(0.5), 1e-12);
}

TEST(ImageMap, APinholeSeesItsFieldOfViewBetweenItsBorders) {
  const CameraModel model = pinhole_of_view({640, 480}, 90 * kRadians);
  EXPECT_NEAR(angle_from_axis(*unproject(model, {-0.5, 239.5})), 45 * kRadians, 1e-12);
  EXPECT_NEAR(angle_from_axis(*unproject(model, {639.5, 239.5})), 45 * kRadians, 1e-12);
}

TEST(ImageMap, NothingIsSeenBehindThePinholeNorBeyondTheLimit) {
  const Camera source = pinhole({64, 48}, 60);
  const ImageMap behind = map_between(source, pinhole({64, 48}, 60), turned(std::numbers::pi, 0, 0));
  EXPECT_TRUE(std::ranges::all_of(behind.uv, [](float at) { return std::isnan(at); }));
  const ImageMap limited = map_between(source, source, {}, 10 * kRadians);
  const std::vector<std::uint8_t> mask = seen(limited, *source.image_size);
  const double radius = std::tan(10 * kRadians) * parameter_values(source.model)[0];
  EXPECT_NEAR(static_cast<double>(std::ranges::count(mask, 255)), std::numbers::pi * radius * radius, 2 * radius);
}

TEST(ImageMap, ACameraSeesAllOfItsOwnImage) {
  for (const Camera& camera : {test::euroc(), test::kalibr_ds(), test::kalibr_eucm(), test::rational_lens()}) {
    const std::vector<std::uint8_t> mask = seen(map_between(camera, camera), *camera.image_size);
    EXPECT_EQ(std::ranges::count(mask, 0), 0) << model_info(camera.model).id;
  }
}

TEST(ImageMap, RefusesCamerasThatAreNone) {
  Diagnostics diagnostics;
  Camera without_size = test::tumvi();
  without_size.image_size.reset();
  EXPECT_FALSE(ImageMapper::between(without_size, test::tumvi(), {}, {}, diagnostics));
  EXPECT_FALSE(ImageMapper::between(test::tumvi(), without_size, {}, {}, diagnostics));
  Camera broken = test::tumvi();
  parameter_values(broken.model)[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(ImageMapper::between(broken, test::tumvi(), {}, {}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace fca
