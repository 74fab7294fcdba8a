// SPDX-License-Identifier: BSD-3-Clause
// project, unproject and show through the pipe, as scripts use them.
#include "cli/run_program.h"
#include "cli/told.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

std::vector<std::vector<double>> rows_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::vector<double> row;
    std::istringstream fields(line);
    for (std::string field; fields >> field;) row.push_back(std::strtod(field.c_str(), nullptr));
    rows.push_back(row);
  }
  return rows;
}

rapidjson::Document json_of(const RunResult& run) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseValidateEncodingFlag | rapidjson::kParseFullPrecisionFlag>(run.out.c_str(), run.out.size());
  EXPECT_FALSE(document.HasParseError()) << run.out;
  return document;
}

TEST(Points, ThePrincipalPointIsTheAxis) {
  const RunResult run = run_program({"project", kEucm}, {.input = "0 0 1\n0 0 5\n"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const auto rows = rows_of(run.out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0], (std::vector<double>{254.9585771534443, 256.88154645599448}));
  EXPECT_EQ(rows[1], rows[0]);
}

TEST(Points, SeventeenDigitsAreTheWholeDouble) {
  const RunResult run = run_program({"unproject", kEucm}, {.input = "100.3 200.7\n"});
  const auto rows = rows_of(run.out);
  ASSERT_EQ(rows.size(), 1U);
  ASSERT_EQ(rows[0].size(), 3U);
  EXPECT_NEAR(std::hypot(rows[0][0], rows[0][1], rows[0][2]), 1.0, 4e-16);
  std::istringstream fields(run.out);
  for (std::string field; fields >> field;) {
    char again[64];
    std::snprintf(again, sizeof again, "%.17g", std::strtod(field.c_str(), nullptr));
    EXPECT_EQ(field, again);
  }
}

TEST(Points, PixelsSurviveUnprojectAndProject) {
  for (const char* camera : {"cam0", "cam1"}) {
    std::string pixels;
    for (int u = 0; u < 512; u += 37) {
      for (int v = 0; v < 512; v += 41) pixels += std::to_string(u) + ".25 " + std::to_string(v) + ".5\n";
    }
    const RunResult rays = run_program({"unproject", kTumvi, "--camera", camera}, {.input = pixels});
    ASSERT_EQ(rays.code, 0) << rays.err;
    const RunResult back = run_program({"project", kTumvi, "--camera", camera}, {.input = rays.out});
    ASSERT_EQ(back.code, 0) << back.err;
    const auto before = rows_of(pixels);
    const auto after = rows_of(back.out);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      ASSERT_EQ(after[i].size(), 2U);
      EXPECT_NEAR(after[i][0], before[i][0], 1e-9);
      EXPECT_NEAR(after[i][1], before[i][1], 1e-9);
    }
  }
}

TEST(Points, RowsWithoutAnAnswerAreNan) {
  const RunResult run = run_program({"project", kEucm}, {.input = "0 0 -1\n0 0 1\nnan 0 1\n0 0 0\n.inf 0 1\n"});
  EXPECT_EQ(run.code, 0) << run.err;
  std::istringstream lines(run.out);
  std::string line;
  for (const bool answered : {false, true, false, false, false}) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line == "nan nan", !answered) << line;
  }
  EXPECT_EQ(run_program({"unproject", kEucm}, {.input = "1e6 1e6\n"}).out, "nan nan nan\n");
}

TEST(Points, RaysBeyondNinetyDegreesHavePixels) {
  const RunResult run = run_program({"project", kTumvi, "--camera", "0"}, {.input = "1 0 -0.1\n"});
  const auto rows = rows_of(run.out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_GT(rows[0].at(0), 254.9 + 190.9 * 1.6) << "the right side of the image, not mirrored to the left";
}

TEST(Points, BlankLinesCommentsAndCommasAreTaken) {
  const RunResult run = run_program({"project", kEucm}, {.input = "# x y z\n\n0,0,1\r\n 0\t0 , 1 \n0 0 1"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(rows_of(run.out).size(), 3U);
}

TEST(Points, AWrongLineIsNamed) {
  for (const char* line : {"0 0", "0 0 1 2", "0 zero 1", "0;0;1"}) {
    const RunResult run = run_program({"project", kEucm}, {.input = std::string("0 0 1\n") + line + "\n"});
    EXPECT_EQ(run.code, 2) << line;
    EXPECT_TRUE(contains(run.err, "line 2")) << run.err;
  }
  EXPECT_EQ(run_program({"project", kEucm}, {.input = ""}).code, 0);
}

TEST(Points, OfSeveralCamerasOneMustBeChosen) {
  const RunResult run = run_program({"project", kTumvi}, {.input = "0 0 1\n"});
  EXPECT_EQ(run.code, 3);
  EXPECT_TRUE(contains(run.err, "--camera")) << run.err;
  EXPECT_EQ(rows_of(run_program({"project", kTumvi, "--camera", "1"}, {.input = "0 0 1\n"}).out).at(0).at(0),
            252.59949716835982);
  EXPECT_EQ(rows_of(run_program({"project", kTumvi, "--camera", "cam0"}, {.input = "0 0 1\n"}).out).at(0).at(0),
            254.93170605935475);
}

TEST(Points, Json) {
  const rapidjson::Document pixels = json_of(run_program({"project", kEucm, "--json"}, {.input = "0 0 1\n0 0 -1\n"}));
  ASSERT_TRUE(pixels.IsObject() && pixels.HasMember("pixels"));
  ASSERT_EQ(pixels["pixels"].Size(), 2U);
  EXPECT_EQ(pixels["pixels"][0]["u"].GetDouble(), 254.9585771534443);
  EXPECT_TRUE(pixels["pixels"][1]["u"].IsNull());
  const rapidjson::Document rays = json_of(run_program({"unproject", kEucm, "--json"}, {.input = "10 20\n"}));
  ASSERT_TRUE(rays.IsObject() && rays.HasMember("rays"));
  EXPECT_TRUE(rays["rays"][0]["z"].IsDouble());
}

TEST(Show, SaysWhatTheFileMeans) {
  const std::vector<std::string> words = {"show", kTumvi, "--with", testdata("formats/kalibr/good/imu.yaml")};
  const RunResult run = run_program(words);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* value : {"kb4", "KannalaBrandt8", "190.978", "512 x 512", "T_cam1_cam0", "200 Hz", "10.11 cm"})
    EXPECT_TRUE(contains(run.out, value)) << value << " is not in\n" << run.out;
  const Told told(words);
  const rapidjson::Value& file = told.json()["files"][0];
  EXPECT_STREQ(file["imus"][0]["name"].GetString(), "imu0");
  for (const char* noise : {"gyroscope_noise_density", "gyroscope_random_walk"}) EXPECT_TRUE(file["imus"][0][noise].IsDouble());
  const auto readers = file["read_by"].GetArray();
  EXPECT_TRUE(std::ranges::any_of(readers, [](const auto& reader) {
    return reader["program"] == "Kalibr" && reader["loads"].GetBool();
  })) << told.text();
}

TEST(Show, NeverAnEscapeSequenceInAPipe) {
  const TemporaryFolder folder;
  const std::string path = folder.write("esc.yaml", with_replaced(read_file(kEucm), "/cam0/image_raw", "\"\\e[31mred\\a\""));
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"show", path}, {"show", path, "--json"}, {"convert", path, "--to", "orbslam3"}}) {
    const RunResult run = run_program(words);
    EXPECT_EQ((run.out + run.err).find('\x1b'), std::string::npos) << words[0] << ": a file's text must not drive the terminal";
    EXPECT_EQ((run.out + run.err).find('\a'), std::string::npos) << words[0];
  }
}

TEST(Show, JsonHasTheContractsKeys) {
  const rapidjson::Document json = json_of(run_program({"show", kTumvi, kEucm, "--json"}));
  ASSERT_TRUE(json.IsObject());
  EXPECT_TRUE(json["fca_io"].IsString());
  ASSERT_TRUE(json["files"].IsArray());
  ASSERT_EQ(json["files"].Size(), 2U);
  const rapidjson::Value& file = json["files"][0];
  EXPECT_EQ(std::string(file["file"].GetString()), kTumvi);
  EXPECT_STREQ(file["format"].GetString(), "kalibr");
  EXPECT_TRUE(file["why"].IsString());
  EXPECT_TRUE(file["imus"].IsArray());
  ASSERT_EQ(file["cameras"].Size(), 2U);
  EXPECT_EQ(file["cameras"][0]["parameters"]["fx"].GetDouble(), 190.97847715128717);
}

TEST(Show, JsonOfABadFileIsStillOneDocument) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"show", folder.write("bad\xFF.yaml", "a: [1\n"), "--json"});
  EXPECT_EQ(run.code, 2);
  const rapidjson::Document json = json_of(run);
  ASSERT_TRUE(json.IsObject());
  const rapidjson::Value& diagnostics = json["files"][0]["diagnostics"];
  ASSERT_EQ(diagnostics.Size(), 1U);
  EXPECT_STREQ(diagnostics[0]["severity"].GetString(), "error");
  EXPECT_STREQ(diagnostics[0]["code"].GetString(), "yaml-syntax");
  EXPECT_TRUE(diagnostics[0]["line"].IsInt() && diagnostics[0]["column"].IsInt() && diagnostics[0]["message"].IsString() &&
              diagnostics[0]["file"].IsString());
}

TEST(Show, CamerasCanBeChosen) {
  const rapidjson::Document json = json_of(run_program({"show", kTumvi, "--camera", "1,0", "--json"}));
  const rapidjson::Value& cameras = json["files"][0]["cameras"];
  ASSERT_EQ(cameras.Size(), 2U);
  EXPECT_EQ(cameras[0]["parameters"]["fx"].GetDouble(), 190.44236969414825);
  EXPECT_EQ(json_of(run_program({"show", kTumvi, "--camera", "cam1", "--json"}))["files"][0]["cameras"].Size(), 1U);
}

}  // namespace
}  // namespace fca::test
