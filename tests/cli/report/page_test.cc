// SPDX-License-Identifier: BSD-3-Clause
// What a page says, and that it can do nothing else: no script, no request, no byte of a file that is more than text.
#include "pages.h"

#include <fca/formats/text/numbers.h>
#include <fca/models/camera_model.h>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

const std::vector<std::string> kToEucm = {kTumvi, "--with", kImu, "--to", "orbslam3", "--model", "eucm"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Report, FetchesAndRunsNothing) {
  const std::string html = page(kToEucm);
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_TRUE(contains(html, "default-src 'none'") || contains(html, "default-src &#39;none&#39;"));
  for (const char* never : {"<script", "://", "@import", "javascript:", "<iframe", "<object", "<form"})
    EXPECT_FALSE(contains(html, never)) << never;
  for (const std::string& link : all_between(html, "href=\"", "\"")) EXPECT_TRUE(link.starts_with("data:")) << link;
  for (const std::string& link : all_between(html, "url(", ")")) EXPECT_TRUE(link.starts_with("#")) << link;
  EXPECT_FALSE(contains(html, " src="));
  // An event of an element runs script, too.
  for (const char* never : {" onload", " onerror", " onclick"}) EXPECT_FALSE(contains(html, never)) << never;
}

TEST(Report, HasAMapAndCurvesOfEveryCamera) {
  const std::string html = page(kToEucm);
  EXPECT_EQ(pictures(html).size(), 2U);
  for (const char* title :
       {">Error over the image<", ">Radius over angle<", ">Error over angle<", ">Error in bands of angles<"})
    EXPECT_EQ(count_of(html, title), 2U) << title;
  EXPECT_EQ(count_of(html, ">From above cam0<"), 1U);
  EXPECT_EQ(count_of(html, ">From the right of cam0<"), 1U);
  for (const char* section :
       {">Cameras</h2>", ">IMU</h2>", ">What check finds</h2>", ">Lost</h3>", ">How this page was made</h2>"})
    EXPECT_EQ(count_of(html, section), 1U) << section;
}

TEST(Report, OfAFileAloneShowsWhereItsPixelsLook) {
  const std::string html = page({kTumvi});
  EXPECT_EQ(pictures(html).size(), 2U);
  EXPECT_EQ(count_of(html, ">Angle from the axis over the image<"), 2U);
  EXPECT_FALSE(contains(html, ">Error over the image<"));
  EXPECT_FALSE(contains(html, ">Lost<"));
}

// What a model does not reach is lost, whatever the file can say.
TEST(Report, CountsWhatAModelDoesNotReachAmongTheLosses) {
  const std::string html = page({kTumvi, "--camera", "cam0", "--to", "opencv", "--model", "radtan", "--max-angle", "80"});
  EXPECT_FALSE(contains(html, ">Nothing.<"));
  EXPECT_TRUE(contains(html, " of cam0: radtan "));
  EXPECT_FALSE(contains(page({kTumvi, "--camera", "cam0", "--to", "kalibr"}), " of cam0: kb4 "));
}

TEST(Report, HasTheNumbersOfConvert) {
  const std::string html = page(kToEucm);
  const RunResult run = run_program(with({"convert"}, with(kToEucm, {"--json"})));
  rapidjson::Document json;
  json.Parse(run.out.c_str());
  ASSERT_FALSE(json.HasParseError()) << run.out << run.err;
  const auto px = [](const rapidjson::Value& value) { return text::format_short(value.GetDouble(), 3); };
  for (const auto& camera : json["cameras"].GetArray()) {
    const auto& error = camera["error_px"];
    const std::string words = "rms " + px(error["rms"]) + " px, max " + px(error["max"]) + " px at (";
    EXPECT_TRUE(contains(html, words)) << words;
    EXPECT_TRUE(contains(html, "proven below " + px(error["bound"]) + " everywhere"));
    EXPECT_TRUE(contains(html, "mean " + px(error["mean"]) + ", median " + px(error["p50"]) + ", 95 % " + px(error["p95"])));
    for (const auto& band : camera["bands"].GetArray()) {
      EXPECT_TRUE(contains(html, ">" + px(band["rms_px"]) + "</td>")) << px(band["rms_px"]);
      EXPECT_TRUE(contains(html, ">" + px(band["max_px"]) + "</td>")) << px(band["max_px"]);
    }
    for (const auto& parameter : camera["parameters"].GetObject()) {
      const std::string said =
          std::string(parameter.name.GetString()) + " " + text::format_short(parameter.value.GetDouble(), 9);
      EXPECT_TRUE(contains(html, said)) << said;
    }
  }
  EXPECT_GT(json["losses"].Size(), 0U);
  for (const auto& loss : json["losses"].GetArray()) EXPECT_TRUE(contains(html, loss["what"].GetString()));
  for (const auto& value : json["defaults"].GetArray()) EXPECT_TRUE(contains(html, value["key"].GetString()));
}

// What decides the bytes of a file decides what its page shows: the losses and the made-up values of just that command.
TEST(Report, TakesWhatConvertTakes) {
  const TemporaryFolder folder;
  const std::string base = folder / "base.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--to", "orbslam3", "-o", base}).code, 0);
  const std::vector<std::vector<std::string>> choices = {
      {"--to", "orbslam3", "--sensor", "mono"},
      {"--to", "orbslam3", "--orbslam3-layout", "old", "--fps", "33"},
      {"--to", "orbslam3", "--set", "Viewer.PointSize=3.5"},
      {"--to", "opencv", "--opencv-layout", "cameras"},
      {"--into", base, "--fps", "33"},
      {"--to", "kalibr", "--rewrite", "--model", "ds"},
  };
  for (const std::vector<std::string>& choice : choices) {
    SCOPED_TRACE(choice.back());
    const std::vector<std::string> words = with({kTumvi}, choice);
    const std::string html = page(words);
    const RunResult run = run_program(with({"convert"}, with(words, {"--json"})));
    rapidjson::Document json;
    json.Parse(run.out.c_str());
    ASSERT_FALSE(json.HasParseError()) << run.out << run.err;
    for (const auto& loss : json["losses"].GetArray()) EXPECT_TRUE(contains(html, loss["what"].GetString()));
    for (const auto& value : json["defaults"].GetArray()) EXPECT_TRUE(contains(html, value["key"].GetString()));
    std::string typed = "fca-io convert " + words.front();
    for (const std::string& word : choice) EXPECT_TRUE(contains(html.substr(html.rfind(typed)), word)) << word;
  }
}

TEST(Report, EveryModelStandsBesideTheOthers) {
  const std::string html = page({kTumvi, "--model", "all", "--camera", "0"});
  for (const ModelInfo& model : all_models())
    EXPECT_EQ(contains(html, ">" + std::string(model.id)), !model.kept_only) << model.id;
  EXPECT_EQ(count_of(html, "recommended<"), 1U);
  const std::size_t recommended = html.find("recommended<");
  const std::size_t row = html.rfind("<tr", recommended);
  EXPECT_TRUE(contains(html.substr(row, recommended - row), ">kb4"));
  // OCamCalib's program reads one model, whatever is best.
  EXPECT_TRUE(contains(page({kTumvi, "--model", "all", "--to", "ocamcalib", "--camera", "0"}), ">For OCamCalib"));
}

TEST(Report, IsTheSameEveryTime) { EXPECT_EQ(page(kToEucm), page(kToEucm)); }

TEST(Report, WhatAFileSaysStaysText) {
  const TemporaryFolder folder;
  const std::string hostile = "</title><script>alert(1)</script><img src=x onerror=alert(1)>\\\" style=\\\"x' & \\u202e";
  const std::string file = folder.write(
      "'\"><script>x.yaml", kEquidistant + "  rostopic: \"" + hostile + "\"\n" + "  \"<script>alert(2)</script>\": 1\n");
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--to", "orbslam3"}, {"--model", "all"}}) {
    const std::string html = page(with({file}, more));
    EXPECT_FALSE(contains(html, "<script"));
    EXPECT_FALSE(contains(html, "<img"));
    EXPECT_FALSE(contains(html, "\xE2\x80\xAE")) << "it turns around what stands beside it";
    EXPECT_EQ(count_of(html, "</title>"), 1U);
    EXPECT_TRUE(contains(html, "&lt;script&gt;")) << "and is shown as it is";
    // Every quote of the page ends an attribute that it began.
    for (const std::string& tag : all_between(html, "<", ">")) EXPECT_EQ(count_of(tag, "\"") % 2, 0U) << tag;
  }
}

TEST(Report, NamesOfCamerasStayText) {
  const TemporaryFolder folder;
  std::string json = read_file(testdata("formats/woodscape/good/front.json"));
  const std::size_t at = json.find("\"name\"");
  ASSERT_NE(at, std::string::npos);
  const std::size_t from = json.find('"', json.find(':', at)) + 1;
  json.replace(from, json.find('"', from) - from, "<script>FV</script>");
  const std::string html = page({folder.write("front.json", json), "--model", "eucm"});
  EXPECT_FALSE(contains(html, "<script"));
  EXPECT_TRUE(contains(html, "&lt;script&gt;FV"));
}

TEST(Report, GoesWhereItIsToldTo) {
  const TemporaryFolder folder;
  const std::string path = folder / "page.html";
  ASSERT_EQ(run_program({"report", kTumvi, "-o", path}).code, 0);
  const std::string first = read_file(path);
  EXPECT_TRUE(first.starts_with("<!doctype html>"));
  const RunResult again = run_program({"report", kTumvi, "--model", "ds", "-o", path});
  EXPECT_EQ(again.code, 4) << again.err;
  EXPECT_TRUE(contains(again.err, "--force")) << again.err;
  EXPECT_EQ(read_file(path), first);
  EXPECT_EQ(run_program({"report", kTumvi, "--model", "ds", "-o", path, "--force"}).code, 0);
  EXPECT_NE(read_file(path), first);
  EXPECT_EQ(folder.names(), std::set<std::string>{"page.html"});
}

TEST(Report, ReadsStandardInputOnce) {
  const std::string html = page({"-", "--to", "orbslam3"}, {.input = read_file(kTumvi)});
  EXPECT_TRUE(contains(html, "standard input"));
  EXPECT_TRUE(contains(html, ">Lost<"));
  EXPECT_EQ(pictures(html).size(), 2U);
}

TEST(Report, RefusesWhatItCannotShow) {
  const TemporaryFolder folder;
  const std::string path = folder / "page.html";
  const auto code = [&path](std::vector<std::string> words) {
    words.insert(words.begin(), "report");
    words.insert(words.end(), {"-o", path});
    const RunResult run = run_program(words);
    EXPECT_FALSE(run.err.empty());
    return run.code;
  };
  EXPECT_EQ(code({kTumvi, "--to", "nothing"}), 3);
  EXPECT_EQ(code({kTumvi, "--model", "nothing"}), 3);
  EXPECT_EQ(code({kTumvi, kTumvi}), 3) << "two calibrations";
  EXPECT_EQ(code({kTumvi, "--objective", "nothing"}), 3);
  EXPECT_EQ(code({kTumvi, "--to", "kalibr", "--fps", "20"}), 3) << "nothing of that in the format";
  EXPECT_EQ(code({kTumvi, "--fps", "20"}), 3) << "of a file that is not written";
  EXPECT_EQ(code({kTumvi, "--model", "all", "--set", "Viewer.PointSize=3"}), 3);
  EXPECT_EQ(code({kImu, "--model", "eucm"}), 2) << "no camera";
  EXPECT_EQ(code({folder.write("bad.yaml", "cam0: [")}), 2);
  EXPECT_EQ(code({folder / "missing.yaml"}), 4);
  EXPECT_FALSE(fs::exists(path));
}

// A page is what one looks at when something is wrong.
TEST(Report, ShowsWhatConvertWouldNotWrite) {
  const TemporaryFolder folder;
  const std::string no_size = with_replaced(kEquidistant, "  resolution: [400, 300]\n", "");
  const std::string html = page({folder.write("nosize.yaml", no_size)});
  EXPECT_TRUE(contains(html, "--size WxH"));
  EXPECT_TRUE(contains(html, ">Radius over angle<"));
  EXPECT_TRUE(page({kImu}).size() > 1000) << "an IMU alone";
}

}  // namespace
}  // namespace fca::test
