// SPDX-License-Identifier: BSD-3-Clause
// The pictures of a page show what was computed: parts of the image, contours, and where the worst pixel is.
#include "cli/lit_image.h"
#include "pages.h"

#include <rapidjson/document.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace fca::test {
namespace {

/// The field of view of the first camera, by convert.
rapidjson::Document converted(const std::string& model, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"convert", kTumvi, "--to", "kalibr", "--model", model, "--json"};
  words.insert(words.end(), more.begin(), more.end());
  rapidjson::Document json;
  json.Parse(run_program(words).out.c_str());
  EXPECT_FALSE(json.HasParseError());
  return json;
}

bool is_stripe(const cv::Vec4b& pixel) {
  return pixel == cv::Vec4b(0x56, 0x3A, 0xD8, 0xFF) || pixel == cv::Vec4b(0xE6, 0xE3, 0xFF, 0xFF);
}

template <class Which>
double share_of(const cv::Mat4b& picture, Which&& which) {
  return static_cast<double>(std::count_if(picture.begin(), picture.end(), which)) / static_cast<double>(picture.total());
}

TEST(ReportPicture, ShowsWhichPartsWereScored) {
  constexpr double kOfTheImage = 2e-3;  // a lattice's shares next to pixels'
  const rapidjson::Document eucm = converted("eucm", {"--max-angle", "97.5"});
  const std::vector<cv::Mat4b> maps = pictures(page({kTumvi, "--model", "eucm", "--max-angle", "97.5"}));
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0].size(), cv::Size(512, 512));
  EXPECT_NEAR(share_of(maps[0], [](const cv::Vec4b& p) { return p[3] == 0; }),
              eucm["cameras"][0]["domain"]["outside_lens_share"].GetDouble(), kOfTheImage);
  EXPECT_EQ(share_of(maps[0], is_stripe), 0.0);

  const rapidjson::Document radtan = converted("radtan");
  const std::vector<cv::Mat4b> striped = pictures(page({kTumvi, "--to", "kalibr", "--model", "radtan"}));
  ASSERT_EQ(striped.size(), 2U);
  EXPECT_NEAR(share_of(striped[0], is_stripe), radtan["cameras"][0]["domain"]["unrepresentable_share"].GetDouble(),
              kOfTheImage);
  EXPECT_EQ(share_of(striped[0], [](const cv::Vec4b& p) { return p[3] == 0; }), 0.0);
}

// The rim is drawn where the circle is, and what lies beyond it is no lens.
TEST(ReportPicture, ShowsTheLensCircleWhereItIs) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const Lit lit{.u = 291.0, .v = 233.0, .radius = 210.0};
  const std::string seen = folder.write("seen.pgm", lit.file());
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--to", "kalibr", "--model", "eucm"}, {"--model", "all"}}) {
    std::vector<std::string> words = {chain, "--lens-circle", seen};
    words.insert(words.end(), more.begin(), more.end());
    const std::string html = page(words);
    const cv::Mat4b map = pictures(html).at(0);
    ASSERT_EQ(map.size(), cv::Size(512, 512));
    int wrong = 0;
    for (int v = 0; v < map.rows; ++v) {
      for (int u = 0; u < map.cols; ++u) {
        constexpr double kFound = 1.5;  // px: how well a circle is found in an image
        if (std::abs(std::hypot(u - lit.u, v - lit.v) - lit.radius) > kFound && (map(v, u)[3] == 0) == lit.contains(u, v))
          ++wrong;
      }
    }
    EXPECT_EQ(wrong, 0) << "pixels";
    // A picture in the picture, as wide as the image, with the rim in it.
    const std::vector<std::string> rims = all_between(html, "<circle class=\"rim\"", ">");
    ASSERT_EQ(rims.size(), 1U);
    const std::string before = html.substr(0, html.find("<circle class=\"rim"));
    const std::string inner = before.substr(before.rfind("<svg"));
    const auto number = [](const std::string& element, const std::string& attribute) {
      const std::vector<std::string> values = all_between(element, " " + attribute + "=\"", "\"");
      return values.empty() ? 0.0 : std::strtod(values.front().c_str(), nullptr);
    };
    const double scale = number(inner, "width") / lit.width;
    ASSERT_GT(scale, 0.0);
    // Pixel 0 is as wide as the others: its centre is half of it from the border.
    EXPECT_NEAR(number(rims.front(), "cx") / scale - 0.5, lit.u, 1.0);
    EXPECT_NEAR(number(rims.front(), "cy") / scale - 0.5, lit.v, 1.0);
    EXPECT_NEAR(number(rims.front(), "r") / scale, lit.radius, 1.0);
  }
}

/// How bright people see a colour, about (viridis rises from one end to the other).
double brightness(const cv::Vec4b& pixel) { return 0.114 * pixel[0] + 0.587 * pixel[1] + 0.299 * pixel[2]; }

TEST(ReportPicture, IsBrightestAtTheWorstPixel) {
  const rapidjson::Document json = converted("eucm");
  const std::string html = page({kTumvi, "--model", "eucm"});
  const cv::Mat4b map = pictures(html).at(0);
  const auto& at = json["cameras"][0]["error_px"]["max_at"];
  const cv::Point worst(static_cast<int>(std::lround(at[0].GetDouble())), static_cast<int>(std::lround(at[1].GetDouble())));
  double brightest = 0.0;
  for (const cv::Vec4b& pixel : map) brightest = std::max(brightest, brightness(pixel));
  EXPECT_GE(brightness(map(worst)), brightest - 2.0);
  // And the ring is around it: the map is 476 wide, 2 from the figure's border.
  const double x = 2.0 + (at[0].GetDouble() + 0.5) * 476.0 / 512.0;
  const std::string ring = all_between(html, "class=\"ring\" cx=\"", "\"").at(0);
  EXPECT_NEAR(std::stod(ring), x, 0.01);
}

// A lens r = f theta: lines of equal angle are circles whose radius is known.
TEST(ReportPicture, ContoursLieWhereTheValueIs) {
  const TemporaryFolder folder;
  const std::string html = page({folder.write("camchain.yaml", kEquidistant)});
  const std::vector<std::string> paths = all_between(html, "class=\"contour\" d=\"", "\"");
  ASSERT_GE(paths.size(), 4U);
  constexpr double kScale = 476.0 / 400.0;
  std::vector<double> levels;
  for (std::string path : paths) {
    std::ranges::replace_if(
        path, [](char c) { return c == 'M' || c == 'L' || c == 'Z'; }, ' ');
    std::istringstream numbers(path);
    double least = 1e9;
    double most = 0.0;
    for (double x = 0.0, y = 0.0; numbers >> x >> y;) {
      const double radius = std::hypot((x - 2.0) / kScale - 200.0, (y - 2.0) / kScale - 150.0);
      least = std::min(least, radius);
      most = std::max(most, radius);
    }
    EXPECT_LT(most - least, 0.5) << "px";
    levels.push_back(0.5 * (least + most) / 100.0 * 57.29577951308232);
  }
  for (const double level : levels) EXPECT_NEAR(level, 20.0 * std::round(level / 20.0), 0.2) << "deg";
}

}  // namespace
}  // namespace fca::test
