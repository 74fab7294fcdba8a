// SPDX-License-Identifier: BSD-3-Clause
// PSNR and SSIM against their definitions, written here as plain sums over windows.
#include <fca/compare/image_similarity.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace fca {
namespace {

GreyImage random_image(int width, int height, unsigned seed, float full_scale = 255.0F) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> sample(0.0F, full_scale);
  GreyImage image{width, height, full_scale, {}};
  for (int i = 0; i < width * height; ++i) image.samples.push_back(sample(random));
  return image;
}

/// The same with some noise, so that the two are alike.
GreyImage with_noise(GreyImage image, double deviation) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, deviation);
  for (float& sample : image.samples) sample = static_cast<float>(sample + noise(random));
  return image;
}

struct Reference {
  double psnr_db = 0.0;
  double ssim = 0.0;
};

/// By the definition, each of the 121 weights in one loop.
Reference by_definition(const GreyImage& a, const GreyImage& b, const std::vector<std::uint8_t>& mask) {
  const auto at = [&](const GreyImage& image, int u, int v) {
    return static_cast<double>(image.samples[static_cast<std::size_t>(v * image.width + u)]);
  };
  const auto counts = [&](int u, int v) {
    if (u < 0 || v < 0 || u >= a.width || v >= a.height) return false;
    return mask.empty() || mask[static_cast<std::size_t>(v * a.width + u)] != 0;
  };
  double square = 0.0;
  int pixels = 0;
  double ssim = 0.0;
  int windows = 0;
  const double L = a.full_scale;
  for (int v = 0; v < a.height; ++v) {
    for (int u = 0; u < a.width; ++u) {
      if (counts(u, v)) {
        square += std::pow(at(a, u, v) - at(b, u, v), 2);
        ++pixels;
      }
      double sum = 0.0;
      double mean_a = 0.0;
      double mean_b = 0.0;
      bool whole = true;
      const auto over_window = [&](const auto& use) {
        for (int j = -5; j <= 5; ++j) {
          for (int i = -5; i <= 5; ++i) use(std::exp(-(i * i + j * j) / (2.0 * 1.5 * 1.5)), u + i, v + j);
        }
      };
      over_window([&](double weight, int x, int y) {
        whole = whole && counts(x, y);
        sum += weight;
      });
      if (!whole) continue;
      over_window([&](double weight, int x, int y) {
        mean_a += weight / sum * at(a, x, y);
        mean_b += weight / sum * at(b, x, y);
      });
      double variance_a = 0.0;
      double variance_b = 0.0;
      double covariance = 0.0;
      over_window([&](double weight, int x, int y) {
        variance_a += weight / sum * std::pow(at(a, x, y) - mean_a, 2);
        variance_b += weight / sum * std::pow(at(b, x, y) - mean_b, 2);
        covariance += weight / sum * (at(a, x, y) - mean_a) * (at(b, x, y) - mean_b);
      });
      const double C1 = std::pow(0.01 * L, 2);
      const double C2 = std::pow(0.03 * L, 2);
      ssim += (2.0 * mean_a * mean_b + C1) * (2.0 * covariance + C2) /
              ((mean_a * mean_a + mean_b * mean_b + C1) * (variance_a + variance_b + C2));
      ++windows;
    }
  }
  return {20.0 * std::log10(L) - 10.0 * std::log10(square / pixels), ssim / windows};
}

void expect_by_definition(const GreyImage& a, const GreyImage& b, const std::vector<std::uint8_t>& mask) {
  const ImageSimilarity ours = similarity(a, b, mask);
  const Reference reference = by_definition(a, b, mask);
  EXPECT_NEAR(psnr_db(ours.mean_square, a.full_scale), reference.psnr_db, 1e-6);
  EXPECT_NEAR(ours.ssim, reference.ssim, 1e-6);
}

TEST(ImageSimilarity, IsItsDefinition) {
  const GreyImage image = random_image(41, 29, 1);
  expect_by_definition(image, random_image(41, 29, 2), {});
  for (const double deviation : {0.01, 1.0, 10.0, 60.0}) expect_by_definition(image, with_noise(image, deviation), {});
  const GreyImage deep = random_image(23, 37, 3, 65535.0F);
  expect_by_definition(deep, with_noise(deep, 900.0), {});
}

TEST(ImageSimilarity, CountsOnlyWhatIsInTheMask) {
  const GreyImage image = random_image(40, 30, 4);
  GreyImage other = with_noise(image, 8.0);
  std::vector<std::uint8_t> mask(image.samples.size(), 255);
  for (int v = 0; v < 30; ++v) {
    for (int u = 24; u < 40; ++u) {
      const auto i = static_cast<std::size_t>(v * 40 + u);
      mask[i] = 0;
      other.samples[i] = 0.0F;
    }
  }
  expect_by_definition(image, other, mask);
  EXPECT_NEAR(similarity(image, other, mask).compared, 24.0 / 40.0, 1e-12);
  EXPECT_GT(similarity(image, other, mask).ssim, similarity(image, other).ssim);
}

TEST(ImageSimilarity, OfTheSameImagesIsInfinite) {
  const GreyImage image = random_image(32, 32, 5);
  const ImageSimilarity same = similarity(image, image);
  EXPECT_TRUE(std::isinf(psnr_db(same.mean_square, image.full_scale)));
  EXPECT_NEAR(same.ssim, 1.0, 1e-12);
}

TEST(ImageSimilarity, IsTheSameEitherWay) {
  const GreyImage a = random_image(32, 25, 6);
  const GreyImage b = with_noise(a, 20.0);
  EXPECT_DOUBLE_EQ(similarity(a, b).ssim, similarity(b, a).ssim);
  EXPECT_DOUBLE_EQ(similarity(a, b).mean_square, similarity(b, a).mean_square);
}

TEST(ImageSimilarity, WithoutAWindowSaysSo) {
  const GreyImage small = random_image(10, 10, 8);
  EXPECT_EQ(similarity(small, small).windows, 0.0);
  EXPECT_EQ(similarity(small, small, std::vector<std::uint8_t>(100, 0)).compared, 0.0);
}

}  // namespace
}  // namespace fca
