// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/image_circle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace fca {
namespace {

/// A camera's image of some scene through a lens whose light falls into a circle.
struct Scene {
  int width = 640;
  int height = 480;
  LensCircle circle = {{310.3, 247.8}, 220.4, 0.0, 0.0};
  double brightness = 140.0;
  double noise = 2.0;
  double vignette_px = 2.0;  ///< The rim's softness.
  /// Of the scene's directions, which are lit at all: from, to [rad].
  double lit_from = -4.0;
  double lit_to = 4.0;
  bool flare = false;
  double glow = 0.0;  ///< Beyond the rim, where it begins; it falls off slowly.
  unsigned seed = 1;
};

/// Where a calibration has the axis: near the circle's centre, not at it.
Pixel axis_of(const LensCircle& circle) { return {circle.centre[0] + 6.0, circle.centre[1] - 4.0}; }

constexpr Pixel kMiddle = {319.5, 239.5};

GreyImage rendered(const Scene& scene) {
  std::mt19937 random(scene.seed);
  std::normal_distribution<double> noise(0.0, scene.noise);
  GreyImage image{scene.width, scene.height, 255.0F, {}};
  for (int v = 0; v < scene.height; ++v) {
    for (int u = 0; u < scene.width; ++u) {
      const double du = u - scene.circle.centre[0];
      const double dv = v - scene.circle.centre[1];
      const double light = std::clamp((scene.circle.radius_px - std::hypot(du, dv)) / scene.vignette_px + 0.5, 0.0, 1.0);
      const double angle = std::atan2(dv, du);
      const bool lit = angle >= scene.lit_from && angle <= scene.lit_to;
      const double texture = 1.0 + 0.4 * std::sin(u / 7.0) * std::cos(v / 11.0);
      double value = 9.0 + (lit ? scene.brightness : 2.0) * texture * light;
      // The sun next to the lens: a spot and its ghost, both outside of the circle.
      const double beyond = std::max(0.0, std::hypot(du, dv) - scene.circle.radius_px);
      if (scene.glow > 0.0) value += scene.glow * std::exp(-beyond / 60.0);
      if (scene.flare && (std::hypot(u - 15.0, v - 20.0) < 45.0 || std::hypot(u - 610.0, v - 455.0) < 12.0)) value += 200.0;
      image.samples.push_back(static_cast<float>(std::clamp(std::round(value + noise(random)), 0.0, 255.0)));
    }
  }
  return image;
}

void expect_found(const GreyImage& image, const LensCircle& truth) {
  const std::optional<LensCircle> found = find_image_circle(image, axis_of(truth));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->centre[0], truth.centre[0], 1.0);
  EXPECT_NEAR(found->centre[1], truth.centre[1], 1.0);
  EXPECT_NEAR(found->radius_px, truth.radius_px, 1.5);
  EXPECT_LT(found->rms_px, 1.5);
  EXPECT_GT(found->rim_share, 0.0);
  EXPECT_LE(found->rim_share, 1.0);
}

TEST(ImageCircle, IsFoundWhole) {
  const Scene scene;
  expect_found(rendered(scene), scene.circle);
  EXPECT_GT(find_image_circle(rendered(scene), axis_of(scene.circle))->rim_share, 0.95);
}

TEST(ImageCircle, IsFoundWhereTheImageCutsIt) {
  for (const LensCircle& circle : {LensCircle{{320.0, 240.0}, 300.0, 0.0, 0.0}, LensCircle{{300.0, 250.0}, 330.0, 0.0, 0.0},
                                   LensCircle{{330.0, 235.0}, 370.0, 0.0, 0.0}}) {
    SCOPED_TRACE(circle.radius_px);
    Scene scene;
    scene.circle = circle;
    expect_found(rendered(scene), circle);
  }
}

TEST(ImageCircle, IsFoundFarFromTheMiddleAndSmall) {
  Scene scene;
  scene.circle = {{180.0, 300.0}, 95.0, 0.0, 0.0};
  expect_found(rendered(scene), scene.circle);
}

TEST(ImageCircle, IsFoundInNoiseAndInTheDark) {
  Scene scene;
  scene.noise = 8.0;
  expect_found(rendered(scene), scene.circle);
  scene.noise = 1.0;
  scene.brightness = 18.0;
  expect_found(rendered(scene), scene.circle);
}

TEST(ImageCircle, IsFoundByAPartOfItsRim) {
  Scene scene;
  scene.lit_from = -1.0;
  scene.lit_to = 1.2;
  expect_found(rendered(scene), scene.circle);
  EXPECT_LT(find_image_circle(rendered(scene), axis_of(scene.circle))->rim_share, 0.5);
}

TEST(ImageCircle, IsNotDrawnToFlareBesideIt) {
  Scene scene;
  scene.flare = true;
  expect_found(rendered(scene), scene.circle);
}

TEST(ImageCircle, IsFoundInImagesTogetherWhereNoneShowsIt) {
  std::vector<GreyImage> images;
  for (int i = 0; i < 12; ++i) {
    Scene scene;
    scene.seed = static_cast<unsigned>(i);
    scene.lit_from = -3.2 + 0.55 * i;
    scene.lit_to = scene.lit_from + 0.3;
    images.push_back(rendered(scene));
    EXPECT_FALSE(find_image_circle(images.back(), axis_of(scene.circle))) << i;
  }
  expect_found(brightest(images), Scene().circle);
}

TEST(ImageCircle, IsTheSameInAnotherUnit) {
  GreyImage image = rendered({});
  const std::optional<LensCircle> found = find_image_circle(image, kMiddle);
  ASSERT_TRUE(found);
  for (float& sample : image.samples) sample *= 257.0F;
  image.full_scale = 65535.0F;
  const std::optional<LensCircle> of_16_bits = find_image_circle(image, kMiddle);
  ASSERT_TRUE(of_16_bits);
  EXPECT_NEAR(of_16_bits->radius_px, found->radius_px, 1e-3);
}

// A ring of stray light around the rim is brighter than the corners are dark.
TEST(ImageCircle, IsNotDrawnToAGlowAroundIt) {
  for (const double glow : {5.0, 15.0, 25.0, 40.0}) {
    SCOPED_TRACE(glow);
    Scene scene;
    scene.circle.radius_px = 190.4;
    scene.brightness = 180.0;
    scene.glow = glow;
    expect_found(rendered(scene), scene.circle);
  }
}

TEST(ImageCircle, IsFoundInMuchNoise) {
  Scene scene;
  scene.noise = 20.0;
  expect_found(rendered(scene), scene.circle);
}

TEST(ImageCircle, IsNoLampBesideTheAxis) {
  Scene lamp;
  lamp.circle = {{420.0, 160.0}, 85.0, 0.0, 0.0};
  EXPECT_FALSE(find_image_circle(rendered(lamp), kMiddle));
  EXPECT_TRUE(find_image_circle(rendered(lamp), lamp.circle.centre));
}

TEST(ImageCircle, IsSharpAtALensesEdgeOnly) {
  Scene sharp;
  EXPECT_GT(find_image_circle(rendered(sharp), axis_of(sharp.circle))->sharpness, 0.6);
  Scene soft;
  soft.vignette_px = 200.0;
  const std::optional<LensCircle> found = find_image_circle(rendered(soft), axis_of(soft.circle));
  if (found) {
    EXPECT_LT(found->sharpness, 0.6);
  }
}

std::optional<LensCircle> best_of(const std::vector<Scene>& scenes, std::vector<std::size_t>* contradicting = nullptr) {
  ImageCircleSearch search(axis_of(scenes.front().circle));
  for (const Scene& scene : scenes) search.add(rendered(scene));
  const std::optional<LensCircle> best = search.best();
  if (best && contradicting != nullptr) *contradicting = search.contradicting(*best);
  return best;
}

TEST(ImageCircleSearch, IsNotSpoiltByFurtherImages) {
  const Scene good;
  Scene black;
  black.brightness = 0.0;
  black.noise = 12.0;
  Scene glowing;
  glowing.glow = 30.0;
  glowing.brightness = 20.0;
  for (const std::vector<Scene>& scenes : {std::vector{good}, {good, black}, {black, good}, {good, glowing, black}}) {
    std::vector<std::size_t> contradicting;
    const std::optional<LensCircle> found = best_of(scenes, &contradicting);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->radius_px, good.circle.radius_px, 1.5);
    EXPECT_NEAR(found->centre[0], good.circle.centre[0], 1.0);
  }
  EXPECT_FALSE(best_of({black}));
  EXPECT_FALSE(ImageCircleSearch(kMiddle).best());
}

TEST(ImageCircleSearch, NamesImagesOfAnotherCircle) {
  const Scene scene;
  Scene other;
  other.circle = {{300.0, 240.0}, 170.0, 0.0, 0.0};
  std::vector<std::size_t> contradicting;
  ASSERT_TRUE(best_of({scene, other, scene}, &contradicting));
  EXPECT_FALSE(contradicting.empty());
  ASSERT_TRUE(best_of({scene, scene}, &contradicting));
  EXPECT_TRUE(contradicting.empty());
}

// One image of another camera, however much of a rim it shows, does not outweigh those that agree.
TEST(ImageCircleSearch, BelievesTheImagesThatAgree) {
  const Scene scene;
  Scene half = scene;
  half.lit_from = -1.4;
  half.lit_to = 1.4;
  Scene other_half = scene;
  other_half.lit_from = 1.2;
  Scene other;
  other.circle = {{300.0, 240.0}, 190.0, 0.0, 0.0};
  other.noise = 0.5;
  Scene noisy = scene;
  noisy.noise = 12.0;
  for (const std::vector<Scene>& scenes : {std::vector{half, other_half, other}, {noisy, other, half}, {other, noisy, noisy}}) {
    ImageCircleSearch search(axis_of(scene.circle));
    for (const Scene& each : scenes) search.add(rendered(each));
    const std::optional<LensCircle> found = search.best();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->radius_px, scene.circle.radius_px, 1.5);
    EXPECT_GE(search.showing(*found).size(), 2U);
    const std::vector<std::size_t> contradicting = search.contradicting(*found);
    ASSERT_EQ(contradicting.size(), 1U);
    EXPECT_NEAR(search.alone(contradicting.front())->radius_px, other.circle.radius_px, 1.5);
  }
}

TEST(ImageCircle, IsNoneWhereNoBorderIsDark) {
  Scene everywhere;
  everywhere.circle.radius_px = 1000.0;
  EXPECT_FALSE(find_image_circle(rendered(everywhere), kMiddle));
  Scene nowhere;
  nowhere.brightness = 0.0;
  nowhere.lit_from = 4.0;
  EXPECT_FALSE(find_image_circle(rendered(nowhere), kMiddle));
  EXPECT_FALSE(find_image_circle({640, 480, 255.0F, std::vector<float>(640 * 480, 0.0F)}, kMiddle));
  EXPECT_FALSE(find_image_circle({640, 480, 255.0F, std::vector<float>(640 * 480, 255.0F)}, kMiddle));
  EXPECT_FALSE(find_image_circle({2, 2, 255.0F, std::vector<float>(4, 9.0F)}, kMiddle));
  EXPECT_FALSE(find_image_circle({0, 0, 255.0F, {}}, kMiddle));
}

// A dark wood in two corners, a bright window: no circle parts them.
TEST(ImageCircle, IsNoneInAScene) {
  GreyImage image{640, 480, 255.0F, {}};
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 2.0);
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      double value = 90.0 + 50.0 * std::sin(u / 31.0) * std::sin(v / 17.0 + u / 90.0);
      if (u + v < 330 + 40.0 * std::sin(v / 9.0)) value = 8.0;
      if (u > 480 && v > 300) value = 10.0;
      if (u > 200 && u < 300 && v > 80 && v < 200) value = 250.0;
      image.samples.push_back(static_cast<float>(std::clamp(value + noise(random), 0.0, 255.0)));
    }
  }
  EXPECT_FALSE(find_image_circle(image, kMiddle));
}

}  // namespace
}  // namespace fca
