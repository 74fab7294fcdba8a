// SPDX-License-Identifier: BSD-3-Clause
// compare --report: the page of two calibrations.
#include "pages.h"

#include <fca/formats/text/numbers.h>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

/// The same lens, its image shifted by two pixels: nearly a turn.
std::string shifted() { return with_replaced(kEquidistant, "199.5", "201.5"); }

TEST(ComparisonPage, HasTheNumbersOfCompare) {
  const TemporaryFolder folder;
  const std::string before = folder.write("before.yaml", kEquidistant);
  const std::string after = folder.write("after.yaml", shifted());
  const RunResult run = run_program({"compare", before, after, "--report", folder / "page.html", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  rapidjson::Document json;
  json.Parse(run.out.c_str());
  ASSERT_FALSE(json.HasParseError()) << run.out;
  const std::string html = read_file(folder / "page.html");
  EXPECT_EQ(pictures(html).size(), 1U);
  for (const char* title : {">Difference over the image<", ">Difference over angle<", ">Radius over angle<"})
    EXPECT_EQ(count_of(html, title), 1U) << title;
  const auto px = [](const rapidjson::Value& value) { return text::format_short(value.GetDouble(), 3); };
  const auto& camera = json["files"][0]["cameras"][0];
  EXPECT_TRUE(
      contains(html, "rms " + px(camera["error_px"]["rms"]) + " px, max " + px(camera["error_px"]["max"]) + " px at ("));
  EXPECT_TRUE(contains(html, ">Verdict: "));
  EXPECT_TRUE(contains(html, "rotation between them: "));
  EXPECT_TRUE(contains(html, "rms with the best rotation undone"));
  EXPECT_FALSE(contains(html, "<script"));
}

// A shift of the principal point moves every pixel alike.
TEST(ComparisonPage, IsOfOneColourWhereAllPixelsMoveAlike) {
  const TemporaryFolder folder;
  const std::string path = folder / "page.html";
  ASSERT_EQ(
      run_program({"compare", folder.write("a.yaml", kEquidistant), folder.write("b.yaml", shifted()), "--report", path}).code,
      0);
  const cv::Mat4b map = pictures(read_file(path)).at(0);
  for (const cv::Vec4b& pixel : map) ASSERT_LE(cv::norm(pixel, map(0, 0), cv::NORM_INF), 1.0);
  EXPECT_EQ(map(0, 0)[3], 255);
}

// The other camera is for images of half the size: the same camera, not one that is off by half of the image.
TEST(ComparisonPage, ImagesOfAnotherSizeAreScaled) {
  const TemporaryFolder folder;
  const std::string whole = folder.write("whole.yaml", kEquidistant);
  const std::string half = folder / "half.yaml";
  ASSERT_EQ(run_program({"convert", whole, "--to", "kalibr", "--model", "ds", "--resize", "200x150", "-o", half}).code, 0);
  const std::string path = folder / "page.html";
  ASSERT_EQ(run_program({"compare", whole, half, "--report", path}).code, 0);
  const std::string html = read_file(path);
  EXPECT_TRUE(contains(html, "200 x 150"));
  // The chart of the differences would be of hundreds of pixels.
  const std::vector<std::string> charts = all_between(html, ">Difference over angle<", "</figure>");
  ASSERT_EQ(charts.size(), 1U);
  for (const char* tick : {"100", "1000"})
    EXPECT_FALSE(contains(charts[0], "text-anchor=\"end\">" + std::string(tick) + "</text>"));
  EXPECT_TRUE(contains(charts[0], "class=\"curve rms\""));
}

TEST(ComparisonPage, OfTheSameFileTwiceSaysSo) {
  const TemporaryFolder folder;
  const std::string path = folder / "page.html";
  ASSERT_EQ(run_program({"compare", kTumvi, kTumvi, "--report", path}).code, 0);
  const std::string html = read_file(path);
  EXPECT_EQ(count_of(html, ">identical<"), 2U);
  EXPECT_FALSE(contains(html, ">Difference over the image<"));
}

TEST(ComparisonPage, GoesWhereItIsToldTo) {
  const TemporaryFolder folder;
  const std::string path = folder.write("page.html", "an old file");
  const RunResult run = run_program({"compare", kTumvi, kTumvi, "--report", path});
  EXPECT_EQ(run.code, 4);
  EXPECT_TRUE(contains(run.err, "--force")) << run.err;
  EXPECT_EQ(read_file(path), "an old file");
  EXPECT_EQ(run_program({"compare", kTumvi, kTumvi, "--report", path, "--force"}).code, 0);
  EXPECT_EQ(run_program({"compare", kTumvi, kTumvi, kTumvi, "--report", folder / "other.html"}).code, 3) << "two files";
  EXPECT_EQ(run_program({"compare", kTumvi, kTumvi, "--force"}).code, 3) << "of no use";
  EXPECT_EQ(folder.names(), std::set<std::string>{"page.html"});
}

}  // namespace
}  // namespace fca::test
