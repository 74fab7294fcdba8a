// SPDX-License-Identifier: BSD-3-Clause
// How wide an image sees: from the formula of a pinhole, and what holds of the parts of an image.
#include <fca/rig/fields_of_view.h>
#include <fca/rig/image_change.h>

#include <cmath>
#include <initializer_list>
#include <string_view>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

constexpr double kTolerance = 1e-12;
constexpr double kFocal = 100.0;

struct ParameterValue {
  ParameterId id;
  double value;
};

Camera camera_of(std::string_view model, ImageSize size, std::initializer_list<ParameterValue> parameters) {
  Camera camera;
  camera.name = "cam";
  camera.image_size = size;
  camera.model = *make_model(model);
  for (const auto& [name, value] : parameters) EXPECT_TRUE(set_parameter(camera.model, name, value));
  return camera;
}

Camera pinhole(double cx, double cy) {
  return camera_of("pinhole", {200, 100}, {{"fx", kFocal}, {"fy", kFocal}, {"cx", cx}, {"cy", cy}});
}

Camera fisheye() {
  return camera_of("kb4", {512, 512}, {{"fx", 150.0}, {"fy", 150.0}, {"cx", 255.5}, {"cy", 255.5}, {"k1", -0.01}});
}

TEST(FieldsOfView, OfAPinholeFollowFromTheFormula) {
  const FieldsOfView view = fields_of_view(pinhole(99.5, 49.5));
  EXPECT_NEAR(*view.horizontal, 2.0 * std::atan(99.5 / kFocal), kTolerance);
  EXPECT_NEAR(*view.vertical, 2.0 * std::atan(49.5 / kFocal), kTolerance);
  EXPECT_NEAR(*view.diagonal, 2.0 * std::atan(std::hypot(99.5, 49.5) / kFocal), kTolerance);
  EXPECT_NEAR(*view.largest_from_axis, std::atan(std::hypot(99.5, 49.5) / kFocal), kTolerance);
}

// The column through the axis is none of the image's: the nearest one is, 50 pixels to its side.
TEST(FieldsOfView, BesideTheAxisAreThoseOfTheImagesOwnPixels) {
  const FieldsOfView view = fields_of_view(pinhole(-50.0, 49.5));
  EXPECT_NEAR(*view.horizontal, std::atan(249.0 / kFocal) - std::atan(50.0 / kFocal), kTolerance);
  EXPECT_NEAR(*view.vertical, 2.0 * std::atan(49.5 / std::hypot(kFocal, 50.0)), kTolerance);
}

TEST(FieldsOfView, OfAFisheyeGoBeyondHalfATurn) {
  EXPECT_GT(*fields_of_view(fisheye()).horizontal, 3.1415926);
  EXPECT_NEAR(*horizontal_field_of_view(fisheye()), *fields_of_view(fisheye()).horizontal, kTolerance);
}

TEST(FieldsOfView, EndAtTheLensCircle) {
  Camera camera = fisheye();
  camera.lens_circle = LensCircle{{265.5, 255.5}, 200.0, 1.0, 0.0};
  const FieldsOfView view = fields_of_view(camera);
  EXPECT_FALSE(view.horizontal) << "the border is dark";
  const Pixel furthest = {465.5, 255.5};
  EXPECT_NEAR(*view.largest_from_axis, angle_from_axis(*unproject(camera.model, furthest)), 1e-9);
}

// Two halves that meet in the axis see what the whole sees.
TEST(FieldsOfView, OfTwoHalvesAddUp) {
  Camera whole = fisheye();
  ASSERT_TRUE(set_parameter(whole.model, "cx", 256.0));
  double sum = 0.0;
  for (const ImageRegion& half : {ImageRegion{0, 0, {257, 512}}, ImageRegion{256, 0, {256, 512}}}) {
    Diagnostics diagnostics;
    sum += *fields_of_view(*with_changed_images(whole, {.crop = half}, diagnostics)).horizontal;
  }
  EXPECT_NEAR(sum, *fields_of_view(whole).horizontal, kTolerance);
}

TEST(FieldsOfView, OfAPartAreNeverWider) {
  const Camera whole = fisheye();
  const FieldsOfView all = fields_of_view(whole);
  for (const int x : {0, 100, 300, 460}) {
    for (const int y : {0, 200, 410}) {
      Diagnostics diagnostics;
      const std::optional<Camera> part =
          with_changed_images(whole, {.crop = ImageRegion{x, y, {512 - x, 512 - y}}}, diagnostics);
      ASSERT_TRUE(part);
      const FieldsOfView view = fields_of_view(*part);
      EXPECT_LE(*view.horizontal, *all.horizontal + kTolerance) << x << " " << y;
      EXPECT_LE(*view.vertical, *all.vertical + kTolerance) << x << " " << y;
      EXPECT_LE(*view.diagonal, *all.diagonal + kTolerance) << x << " " << y;
    }
  }
}

TEST(FieldsOfView, EndAtTheLensThatCounts) {
  constexpr double kHalf = 0.5;
  const FieldsOfView view = fields_of_view(fisheye(), kHalf);
  EXPECT_FALSE(view.horizontal);
  EXPECT_LE(*view.largest_from_axis, kHalf);
}

}  // namespace
}  // namespace fca::test
