// SPDX-License-Identifier: BSD-3-Clause
// Images cropped, binned and resized after the calibration: the new camera's pixels are the old ones, mapped.
#include "../models/model_test_support.h"

#include <fca/code.h>
#include <fca/rig/image_change.h>

#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

constexpr double kTolerancePx = 1e-9;

PixelMap some_map(double scale_u, double scale_v) {
  PixelMap map;
  map.scale = {scale_u, scale_v};
  map.shift = {-31.25, 17.5};
  return map;
}

template <CameraModelType M>
void expect_mapped(const TestCamera<M>& camera, const PixelMap& map) {
  const CameraModel before = camera.intrinsics;
  const CameraModel after = with_pixels(before, map);
  EXPECT_TRUE(validate(after).empty());
  EXPECT_NEAR(max_angle(after), max_angle(before), 1e-9);
  const double end = max_angle(before);
  constexpr double kMargin = 1e-2;  // where a formula has a pole, rounding alone moves pixels
  for (const double angle : angles_up_to(end - kMargin)) {
    for (const double azimuth : some_azimuths()) {
      const Ray ray = ray_at(angle, azimuth);
      const std::optional<Pixel> old_pixel = project(before, ray);
      const std::optional<Pixel> new_pixel = project(after, ray);
      ASSERT_EQ(old_pixel.has_value(), new_pixel.has_value()) << angle;
      if (!old_pixel) continue;
      const Pixel expected = map(*old_pixel);
      // Pixels far outside any image have as many digits as others.
      const double tolerance = kTolerancePx * std::max(1.0, std::hypot(expected[0], expected[1]) / 1e4);
      EXPECT_NEAR((*new_pixel)[0], expected[0], tolerance) << angle;
      EXPECT_NEAR((*new_pixel)[1], expected[1], tolerance) << angle;
      const std::optional<Ray> back = unproject(after, expected);
      ASSERT_TRUE(back) << angle;
      EXPECT_LE(angle_between(*back, ray), 1e-8) << angle;
    }
  }
}

template <CameraModelType M>
void expect_all_mapped() {
  constexpr int kNeighbours = 3;
  for (const TestCamera<M>& camera : cameras_and_neighbours_of<M>(kNeighbours)) {
    SCOPED_TRACE(std::string(M::kId) + " " + camera.name);
    expect_mapped(camera, some_map(0.5, 0.5));
    expect_mapped(camera, some_map(0.37, 0.81));  // anisotropic
    expect_mapped(camera, some_map(2.5, 1.25));
  }
}

TEST(ImageChange, EveryModelsPixelsAreMapped) {
  ModelList::for_each([]<CameraModelType M>() { expect_all_mapped<M>(); });
}

std::optional<ChangedImage> changed(const ImageSize& size, const ImageChange& change) {
  Diagnostics diagnostics;
  return changed_image(size, change, diagnostics);
}

ImageSize some_size() { return {*rc::gen::inRange(2, 5000), *rc::gen::inRange(2, 5000)}; }

void check_near(const Pixel& a, const Pixel& b) {
  RC_ASSERT(std::abs(a[0] - b[0]) < kTolerancePx);
  RC_ASSERT(std::abs(a[1] - b[1]) < kTolerancePx);
}

/// The outer corners of an image: half a pixel beyond the centres of its corner pixels.
constexpr Pixel kFirstCorner = {-0.5, -0.5};
Pixel last_corner(const ImageSize& size) { return {size.width - 0.5, size.height - 0.5}; }

RC_GTEST_PROP(ImageChange, AResizeTakesTheEdgesToTheEdges, ()) {
  const ImageSize from = some_size();
  const ImageSize to = some_size();
  const ChangedImage result = changed(from, {.resize = to}).value();
  RC_ASSERT(result.size == to);
  check_near(result.map(kFirstCorner), kFirstCorner);
  check_near(result.map(last_corner(from)), last_corner(to));
}

RC_GTEST_PROP(ImageChange, ARegionsFirstPixelBecomesTheOrigin, ()) {
  const ImageSize from = some_size();
  const int x = *rc::gen::inRange(0, from.width);
  const int y = *rc::gen::inRange(0, from.height);
  const ImageSize size = {*rc::gen::inRange(1, from.width - x + 1), *rc::gen::inRange(1, from.height - y + 1)};
  const ChangedImage result = changed(from, {.crop = ImageRegion{x, y, size}}).value();
  RC_ASSERT(result.size == size);
  check_near(result.map({static_cast<double>(x), static_cast<double>(y)}), {0.0, 0.0});
  RC_ASSERT((result.map.scale == std::array{1.0, 1.0}));
}

// The centre of a bin is the mean of its pixels' centres.
RC_GTEST_PROP(ImageChange, ABinsCentreIsThatOfItsPixels, ()) {
  const ImageSize from = some_size();
  const int n = *rc::gen::inRange(1, std::min(from.width, from.height) + 1);
  const ChangedImage result = changed(from, {.binning = n}).value();
  RC_ASSERT((result.size == ImageSize{from.width / n, from.height / n}));
  const int column = *rc::gen::inRange(0, result.size.width);
  const double mean = column * n + 0.5 * (n - 1);
  check_near(result.map({mean, mean}), {static_cast<double>(column), static_cast<double>(column)});
}

RC_GTEST_PROP(ImageChange, CropThenBinThenResize, ()) {
  const ImageChange change = {.crop = ImageRegion{100, 50, {600, 400}}, .binning = 2, .resize = ImageSize{640, 480}};
  const ChangedImage parallel_for = changed({1000, 800}, change).value();
  const PixelMap crop = changed({1000, 800}, {.crop = change.crop}).value().map;
  const PixelMap bin = changed({600, 400}, {.binning = 2}).value().map;
  const PixelMap resize = changed({300, 200}, {.resize = change.resize}).value().map;
  const Pixel pixel = {static_cast<double>(*rc::gen::inRange(0, 1000)), static_cast<double>(*rc::gen::inRange(0, 800))};
  check_near(parallel_for.map(pixel), resize(bin(crop(pixel))));
}

// A region as far from overflow as an int can be.
TEST(ImageChange, WhatAnImageDoesNotHoldIsAnError) {
  constexpr int kMost = std::numeric_limits<int>::max();
  EXPECT_TRUE(changed({640, 480}, {.crop = ImageRegion{0, 0, {640, 480}}}));
  EXPECT_FALSE(changed({640, 480}, {.crop = ImageRegion{1, 0, {640, 480}}}));
  EXPECT_FALSE(changed({640, 480}, {.crop = ImageRegion{-1, 0, {10, 10}}}));
  EXPECT_FALSE(changed({640, 480}, {.crop = ImageRegion{0, 0, {0, 10}}}));
  EXPECT_FALSE(changed({640, 480}, {.crop = ImageRegion{kMost, kMost, {kMost, kMost}}}));
  EXPECT_FALSE(changed({640, 480}, {.binning = 0}));
  EXPECT_FALSE(changed({640, 480}, {.binning = 481}));
  EXPECT_FALSE(changed({640, 480}, {.resize = ImageSize{0, 480}}));
}

TEST(ImageChange, ALensCircleChangesWithTheImage) {
  Camera camera;
  camera.model = Intrinsics<Pinhole>{{400.0, 400.0, 320.0, 240.0}};
  camera.image_size = {640, 480};
  camera.lens_circle = LensCircle{{310.0, 250.0}, 200.0, 1.0, 0.5, {Code::kOnlyThing, {"a.png"}}};
  const auto change = [&camera](const ImageChange& how, Diagnostics& diagnostics) {
    return with_changed_images(camera, how, diagnostics).value();
  };
  Diagnostics said;
  const LensCircle cropped = change({.crop = ImageRegion{10, 20, {600, 400}}}, said).lens_circle.value();
  EXPECT_EQ(cropped.centre, (Pixel{300.0, 230.0}));
  EXPECT_EQ(cropped.radius_px, 200.0);
  const LensCircle half = change({.resize = ImageSize{320, 240}}, said).lens_circle.value();
  EXPECT_NEAR(half.centre[0], 154.75, 1e-12);
  EXPECT_NEAR(half.centre[1], 124.75, 1e-12);
  EXPECT_NEAR(half.radius_px, 100.0, 1e-12);
  EXPECT_TRUE(said.entries().empty());
  EXPECT_FALSE(change({.resize = ImageSize{320, 480}}, said).lens_circle) << "an ellipse";
  std::vector<Code> codes;
  for (const Diagnostic& entry : said.entries()) codes.push_back(entry.facts.code);
  EXPECT_EQ(codes, (std::vector{Code::kImagesStretched, Code::kLensCircleStretched}));
}

TEST(ImageChange, ACameraWithoutSizeIsAnError) {
  const Camera camera{"cam0", {}, Intrinsics<Pinhole>{{300, 300, 320, 240}}, {}, {}, {}};
  Diagnostics diagnostics;
  EXPECT_FALSE(with_changed_images(camera, {.binning = 2}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(with_changed_images(camera, {}, diagnostics), camera);
}

// The centres that TUM VI's authors publish for 1024 and for 512 pixels (calib_results/pinhole-equi-1024 and -512, which
// rpng/open_vins issue 152 names; the focal lengths of the two were estimated separately).
TEST(ImageChange, TumVi1024BecomesTumVi512) {
  struct Published {
    Pixel centre_1024;
    Pixel centre_512;
  };
  for (const Published& published : {Published{{510.3634, 514.2949}, {254.93170605935475, 256.8974428996504}},
                                     Published{{505.6990, 510.3345}, {252.59949716835982, 254.91723064636983}}}) {
    const PixelMap map = changed({1024, 1024}, {.resize = ImageSize{512, 512}}).value().map;
    const Pixel centre = map(published.centre_1024);
    EXPECT_NEAR(centre[0], published.centre_512[0], 1e-3);
    EXPECT_NEAR(centre[1], published.centre_512[1], 1e-3);
    EXPECT_EQ(map, changed({1024, 1024}, {.binning = 2}).value().map);
  }
}

}  // namespace
}  // namespace fca::test
