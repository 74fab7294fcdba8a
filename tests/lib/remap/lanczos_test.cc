// SPDX-License-Identifier: BSD-3-Clause
// A Lanczos window is OpenCV's where OpenCV can look, and shows a smooth scene as it is everywhere else.
#include <fca/remap/lanczos.h>

#include <opencv2/imgproc.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace fca {
namespace {

constexpr ImageSize kSize{61, 47};

template <class Scene>
GreyImage taken_of(Scene&& scene) {
  GreyImage image{kSize.width, kSize.height, 255.0F, {}};
  for (int v = 0; v < kSize.height; ++v) {
    for (int u = 0; u < kSize.width; ++u) image.samples.push_back(static_cast<float>(scene(u, v)));
  }
  return image;
}

GreyImage noise() {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> grey(0.0F, 255.0F);
  return taken_of([&](int, int) { return grey(random); });
}

// cv::remap knows places to 1/32 px.
TEST(LanczosWindow, IsThatOfCvRemap) {
  GreyImage image = noise();
  const cv::Mat samples(kSize.height, kSize.width, CV_32F, image.samples.data());
  std::mt19937 random(7);
  std::uniform_int_distribution<int> u32(3 * 32, (kSize.width - 5) * 32);
  std::uniform_int_distribution<int> v32(3 * 32, (kSize.height - 5) * 32);
  for (int i = 0; i < 500; ++i) {
    const Pixel place = {u32(random) / 32.0, v32(random) / 32.0};
    const cv::Mat where(1, 1, CV_32FC2, cv::Scalar(place[0], place[1]));
    cv::Mat theirs;
    cv::remap(samples, theirs, where, {}, cv::INTER_LANCZOS4);
    const std::optional<LanczosWindow> window = LanczosWindow::about(place, kSize);
    ASSERT_TRUE(window) << place[0] << " " << place[1];
    EXPECT_NEAR(window->value(image), static_cast<double>(theirs.at<float>(0, 0)), 2e-3) << place[0] << " " << place[1];
  }
}

TEST(LanczosWindow, IsThePixelItselfOnItsCentre) {
  const GreyImage image = noise();
  for (int v = 3; v <= kSize.height - 5; ++v) {
    for (int u = 3; u <= kSize.width - 5; ++u) {
      const std::optional<LanczosWindow> window = LanczosWindow::about({1.0 * u, 1.0 * v}, kSize);
      ASSERT_TRUE(window);
      EXPECT_EQ(static_cast<float>(window->value(image)), image.samples[static_cast<std::size_t>(v * kSize.width + u)]);
    }
  }
}

// Waves of 12 px and more, which the kernel leaves as they are but for half a percent.
TEST(LanczosWindow, ShowsASmoothSceneAsItIs) {
  const auto scene = [](double u, double v) { return 120.0 + 40.0 * std::sin(u / 2.0) + 40.0 * std::cos(v / 3.0 + u / 11.0); };
  const GreyImage image = taken_of(scene);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> u(3.0, kSize.width - 5.0);
  std::uniform_real_distribution<double> v(3.0, kSize.height - 5.0);
  for (int i = 0; i < 2000; ++i) {
    const Pixel place = {u(random), v(random)};
    const std::optional<LanczosWindow> window = LanczosWindow::about(place, kSize);
    ASSERT_TRUE(window);
    EXPECT_NEAR(window->value(image), scene(place[0], place[1]), 0.4) << place[0] << " " << place[1];
  }
}

TEST(LanczosWindow, MakesNothingUpBeyondTheImage) {
  EXPECT_TRUE(LanczosWindow::about({3.0, 3.0}, kSize));
  EXPECT_TRUE(LanczosWindow::about({kSize.width - 4.001, kSize.height - 4.001}, kSize));
  const double huge = std::numeric_limits<double>::max();
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  for (const Pixel& place : {Pixel{2.999, 20.0}, Pixel{20.0, 2.999}, Pixel{kSize.width - 4.0, 20.0},
                             Pixel{20.0, kSize.height - 4.0}, Pixel{-huge, 20.0}, Pixel{20.0, huge}, Pixel{no_number, 20.0}}) {
    EXPECT_FALSE(LanczosWindow::about(place, kSize)) << place[0] << " " << place[1];
  }
}

}  // namespace
}  // namespace fca
