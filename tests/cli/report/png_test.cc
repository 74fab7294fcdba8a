// SPDX-License-Identifier: BSD-3-Clause
// OpenCV's decoder shows the colours of a picture where they were put.
#include "pictures/png.h"
#include "pages.h"

#include <random>

#include <gtest/gtest.h>

namespace fca::cli {
namespace {

Picture random_picture(int width, int height, int colours, bool opaque, std::mt19937& random) {
  const auto byte = [&random] { return static_cast<std::uint8_t>(random() % 256); };
  Picture picture{width, height, {}, {}};
  for (int i = 0; i < colours; ++i) picture.palette.push_back({byte(), byte(), byte(), opaque ? std::uint8_t{0xFF} : byte()});
  if (!opaque) picture.palette.front()[3] = 7;
  for (int i = 0; i < width * height; ++i)
    picture.colours.push_back(static_cast<std::uint8_t>(random() % static_cast<unsigned>(colours)));
  return picture;
}

TEST(Png, IsReadByOpenCvAsItWasDrawn) {
  std::mt19937 random(20261129);
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 7), std::pair(300, 1), std::pair(37, 53)}) {
    for (const int colours : {1, 2, 200, 256}) {
      for (const bool opaque : {true, false}) {
        SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + ", " + std::to_string(colours) + " colours");
        const Picture picture = random_picture(width, height, colours, opaque, random);
        const std::string bytes = png(picture);
        const cv::Mat decoded = cv::imdecode(std::vector<std::uint8_t>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
        ASSERT_EQ(decoded.size(), cv::Size(width, height));
        const cv::Mat4b pixels = test::with_opacity(decoded);
        auto place = picture.colours.begin();
        int wrong = 0;
        for (const cv::Vec4b& pixel : pixels) {
          const Rgba& colour = picture.palette[*place++];
          wrong += pixel == cv::Vec4b(colour[2], colour[1], colour[0], colour[3]) ? 0 : 1;
        }
        EXPECT_EQ(wrong, 0);
      }
    }
  }
}

}  // namespace
}  // namespace fca::cli
