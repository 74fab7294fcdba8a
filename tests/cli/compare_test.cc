// SPDX-License-Identifier: BSD-3-Clause
// The command around comparisons: what it prints, its exit codes, its document, and that it says what convert said.
#include "cli/run_program.h"
#include "cli/told.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

const std::string kOrbslam3 = testdata("formats/orbslam3/good/v1-stereo-inertial.yaml");

rapidjson::Document document_of(const RunResult& run) {
  rapidjson::Document document;
  document.Parse(run.out.c_str());
  EXPECT_FALSE(document.HasParseError()) << run.out << run.err;
  return document;
}

std::string last_line(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

TEST(Compare, AFileBesideItselfIsTheSame) {
  const RunResult run = run_program({"compare", kTumvi, kTumvi, "--max-error", "0"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(last_line(run.out).starts_with("verdict: " + kTumvi + ": ")) << run.out;
  const rapidjson::Document document = document_of(run_program({"compare", kTumvi, kTumvi, "--json"}));
  const auto& file = document["files"][0];
  EXPECT_TRUE(file["identical"].GetBool());
  EXPECT_EQ(file["cameras"].Size(), 2U);
  for (const auto& camera : file["cameras"].GetArray()) EXPECT_EQ(camera["error_px"]["max"].GetDouble(), 0.0);
}

// Through the bytes of the file: formats have other pixel conventions, whose rounding comes back.
TEST(Compare, AConversionIsWhatConvertReported) {
  struct Case {
    std::string input;
    const char* format;
    const char* model;
    const char* max_angle;
  };
  const TemporaryFolder folder;
  for (const Case& each :
       {Case{kTumvi, "orbslam3", "eucm", "97.5"}, Case{kTumvi, "kalibr", "ds", "180"},
        Case{kDs, "ocamcalib", "ocamcalib", "80"}, Case{kDs, "woodscape", "woodscape", "60"},
        Case{kOrbslam3, "opencv", "mei", "70"}, Case{testdata("formats/woodscape/good/front.json"), "kalibr", "kb4", "90"},
        Case{testdata("formats/ocamcalib/good/toolbox.txt"), "kalibr", "eucm", "85"}}) {
    SCOPED_TRACE(each.input + " to " + each.format);
    const std::string output = folder / "converted";
    const RunResult converting =
        run_program({"convert", each.input, "--camera", "0", "--to", each.format, "--model", each.model, "--max-angle",
                     each.max_angle, "-o", output, "--force", "--json", "--no-verify"});
    ASSERT_EQ(converting.code, 0) << converting.err << converting.out;
    const rapidjson::Document converted = document_of(converting);
    const RunResult comparing =
        run_program({"compare", each.input, output, "--camera", "0", "--max-angle", each.max_angle, "--json"});
    ASSERT_EQ(comparing.code, 0) << comparing.err << comparing.out;
    const rapidjson::Document compared = document_of(comparing);
    const auto& theirs = converted["cameras"][0];
    const auto& ours = compared["files"][0]["cameras"][0];
    for (const char* key : {"max_angle_deg", "scored_to_deg", "scored_share", "outside_lens_share", "unrepresentable_share"})
      EXPECT_NEAR(ours["domain"][key].GetDouble(), theirs["domain"][key].GetDouble(), 1e-9) << key;
    EXPECT_STREQ(ours["domain"]["why"].GetString(), theirs["domain"]["why"].GetString());
    for (const char* key : {"rms", "mean", "p50", "p95", "p99", "max"})
      EXPECT_NEAR(ours["error_px"][key].GetDouble(), theirs["error_px"][key].GetDouble(), 1e-9) << key;
    EXPECT_STREQ(ours["to_model"].GetString(), theirs["to_model"].GetString());
    ASSERT_EQ(ours["bands"].Size(), theirs["bands"].Size());
    for (rapidjson::SizeType i = 0; i < ours["bands"].Size(); ++i) {
      for (const char* key : {"from_deg", "to_deg", "share", "rms_px", "max_px"})
        EXPECT_NEAR(ours["bands"][i][key].GetDouble(), theirs["bands"][i][key].GetDouble(), 1e-9) << key;
    }
  }
}

TEST(Compare, TheWorstPixelDecidesTheExitCode) {
  const TemporaryFolder folder;
  const std::string moved = folder.write("moved.yaml", with_replaced(read_file(kTumvi), "254.9317", "255.9317"));
  EXPECT_EQ(run_program({"compare", kTumvi, moved}).code, 0);
  EXPECT_EQ(run_program({"compare", kTumvi, moved, "--max-error", "1.5"}).code, 0);
  const RunResult over = run_program({"compare", kTumvi, moved, "--max-error", "0.5"});
  EXPECT_EQ(over.code, 1);
  EXPECT_TRUE(says(over.err, "error-limit", "0.5")) << over.err;
  // All are tried, the worst code counts.
  const RunResult many = run_program({"compare", kTumvi, moved, kTumvi, "--max-error", "0.5", "--json"});
  EXPECT_EQ(many.code, 1);
  const rapidjson::Document document = document_of(many);
  EXPECT_EQ(document["files"][0]["exit_code"].GetInt(), 1);
  EXPECT_EQ(document["files"][1]["exit_code"].GetInt(), 0);
  EXPECT_EQ(run_program({"compare", kTumvi, moved, "--max-error", "much"}).code, 3);
  EXPECT_EQ(run_program({"compare", kTumvi, moved, "--max-error", "-1"}).code, 3);
  EXPECT_EQ(run_program({"compare", kTumvi, moved, "--join"}).code, 3);
  EXPECT_EQ(run_program({"compare", kTumvi}).code, 3);
  EXPECT_EQ(run_program({"compare", "-", "-"}).code, 3);
}

// Rays beyond --focus are measured, and no limit counts them.
TEST(Compare, FocusIsWhatLimitsCount) {
  const TemporaryFolder folder;
  const std::string ds = folder / "ds.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--camera", "0", "--to", "kalibr", "--model", "ucm", "-o", ds, "--no-verify"}).code,
            0);
  const Told whole({"compare", kTumvi, ds, "--camera", "0"});
  const Told focused({"compare", kTumvi, ds, "--camera", "0", "--focus", "30"});
  const Told narrow({"compare", kTumvi, ds, "--camera", "0", "--max-angle", "30"});
  const auto camera = [](const Told& told) -> const rapidjson::Value& { return told.json()["files"][0]["cameras"][0]; };
  EXPECT_EQ(camera(focused)["error_px"]["max"].GetDouble(), camera(whole)["error_px"]["max"].GetDouble());
  const double most = camera(narrow)["error_px"]["max"].GetDouble();
  EXPECT_EQ(camera(focused)["focus"]["error_px"]["max"].GetDouble(), most);
  EXPECT_TRUE(camera(whole)["focus"].IsNull());
  ASSERT_LT(most, 0.9 * camera(whole)["error_px"]["max"].GetDouble());
  const std::string limit = std::to_string(1.05 * most);
  EXPECT_EQ(run_program({"compare", kTumvi, ds, "--camera", "0", "--max-error", limit}).code, 1);
  EXPECT_EQ(run_program({"compare", kTumvi, ds, "--camera", "0", "--max-error", limit, "--focus", "30"}).code, 0);
  EXPECT_EQ(run_program({"compare", kTumvi, ds, "--camera", "0", "--max-error", limit, "--focus", "150"}).code, 1);
  for (const char* word : {"0", "-3", "181", "wide"})
    EXPECT_EQ(run_program({"compare", kTumvi, ds, "--focus", word}).code, 3) << word;
  for (const char* word : {"0", "-3", "1e9", "far"})
    EXPECT_EQ(run_program({"compare", kTumvi, ds, "--distance", word}).code, 3) << word;
}

TEST(Compare, ATranslationIsSoughtAtADistance) {
  const TemporaryFolder folder;
  const std::string ds = folder / "ds.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--camera", "0", "--to", "kalibr", "--model", "ds", "-o", ds, "--no-verify"}).code,
            0);
  const Told far({"compare", kTumvi, ds, "--camera", "0"});
  const Told near({"compare", kTumvi, ds, "--camera", "0", "--distance", "2"});
  const auto rotated = [](const Told& told) -> const rapidjson::Value& {
    return told.json()["files"][0]["cameras"][0]["rotated"];
  };
  EXPECT_TRUE(rotated(far)["distance_m"].IsNull() && rotated(far)["centre_m"].IsNull());
  EXPECT_EQ(rotated(near)["distance_m"].GetDouble(), 2.0);
  EXPECT_EQ(rotated(near)["centre_m"].Size(), 3U);
  EXPECT_LE(rotated(near)["error_px"]["rms"].GetDouble(), 1.001 * rotated(far)["error_px"]["rms"].GetDouble());
}

// What is missing is off by more than any limit, and not identical.
TEST(Compare, AMissingCameraOrImagePartIsNoPass) {
  const TemporaryFolder folder;
  const std::string text = read_file(kTumvi);
  const std::string one = folder.write("one.yaml", text.substr(0, text.find("cam1:")));
  EXPECT_EQ(run_program({"compare", kTumvi, one}).code, 0);
  EXPECT_EQ(run_program({"compare", kTumvi, one, "--max-error", "1"}).code, 1);
  EXPECT_EQ(run_program({"compare", kTumvi, one, "--max-error", "1", "--camera", "0"}).code, 0);
  // A pinhole ends at 90 deg, this lens's image does not.
  const std::string narrow = folder / "narrow.yaml";
  ASSERT_EQ(
      run_program({"convert", kTumvi, "--camera", "0", "--to", "kalibr", "--model", "pinhole", "-o", narrow, "--no-verify"})
          .code,
      0);
  const RunResult missing = run_program({"compare", kTumvi, narrow, "--camera", "0", "--max-error", "1000"});
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(says(missing.err, "error-limit", "7.1 %")) << missing.err;
  const std::string empty = folder.write("empty.yaml", "");
  const rapidjson::Document document = document_of(run_program({"compare", kTumvi, one, empty, "--json"}));
  for (const auto& file : document["files"].GetArray()) EXPECT_FALSE(file["identical"].GetBool());
}

// Of several differences the verdict names the largest, and none that is mere rounding.
TEST(Compare, TheVerdictNamesTheLargestDifference) {
  const TemporaryFolder folder;
  const auto offsets = [&](const std::string& name, const char* first, const char* second) {
    std::string text = read_file(kTumvi);
    const std::size_t at = text.find("cam1:");
    text.insert(at, std::string("  timeshift_cam_imu: ") + first + "\n");
    if (!text.ends_with('\n')) text += '\n';
    return folder.write(name, text + "  timeshift_cam_imu: " + second + "\n");
  };
  const std::string reference = offsets("reference.yaml", "0.001", "0.002");
  const auto verdict = [&](const std::string& other) {
    const Told told({"compare", reference, other});
    return std::string(told.json()["files"][0]["verdict"].GetString());
  };
  const std::string rounded = verdict(offsets("rounded.yaml", "0.0010000003", "0.0020347"));
  EXPECT_TRUE(contains(rounded, "cam1 time offset")) << rounded;
  EXPECT_FALSE(contains(rounded, "cam0 time offset") || contains(rounded, "more")) << rounded;
  const std::string both = verdict(offsets("both.yaml", "0.00101", "0.0020347"));
  EXPECT_TRUE(contains(both, "cam1 time offset")) << both;
  // Where nothing else differs, rounding is what differs.
  const std::string alone = verdict(offsets("alone.yaml", "0.0010000003", "0.002"));
  EXPECT_TRUE(contains(alone, "cam0 time offset")) << alone;
}

TEST(Compare, BadInputsAreToldAndTheOthersStillCompared) {
  const TemporaryFolder folder;
  const std::string empty = folder.write("empty.yaml", "");
  const std::string missing = folder / "missing.yaml";
  for (const auto& [bad, code] : {std::pair(empty, 2), std::pair(folder.path().string(), 4), std::pair(missing, 4)}) {
    SCOPED_TRACE(bad);
    const RunResult as_file = run_program({"compare", kTumvi, bad, kTumvi});
    EXPECT_EQ(as_file.code, code) << as_file.err;
    EXPECT_TRUE(contains(as_file.err, "verdict: " + bad + ":")) << as_file.err;
    EXPECT_TRUE(contains(as_file.out, "verdict: " + kTumvi + ":")) << as_file.out;
    const RunResult as_reference = run_program({"compare", bad, kTumvi});
    EXPECT_EQ(as_reference.code, code) << as_reference.err;
    EXPECT_EQ(as_reference.out, "");
    const RunResult in_json = run_program({"compare", kTumvi, bad, kTumvi, "--json"});
    EXPECT_EQ(in_json.code, code);
    const rapidjson::Document document = document_of(in_json);
    EXPECT_EQ(document["files"].Size(), 2U);
    EXPECT_TRUE(document["files"][0]["diagnostics"].Size() > 0);
    EXPECT_FALSE(document["files"][0]["identical"].GetBool());
    EXPECT_TRUE(document["files"][1]["identical"].GetBool());
  }
}

TEST(Compare, AnImuBesideACameraHasNothingInCommonAndBesideAnImuAll) {
  const RunResult nothing = run_program({"compare", kTumvi, kImu});
  EXPECT_EQ(nothing.code, 2);
  EXPECT_TRUE(says(nothing.err, "nothing-to-compare")) << nothing.err;
  const TemporaryFolder folder;
  const Told same({"compare", kImu, kImu});
  EXPECT_EQ(same.code(), 0) << same.text();
  const auto& file = same.json()["files"][0];
  EXPECT_TRUE(file["identical"].GetBool()) << same.text();
  EXPECT_STREQ(file["numbers"][0]["owner"].GetString(), "imu0") << same.text();
}

TEST(Compare, TheSizeMayComeFromEither) {
  const TemporaryFolder folder;
  std::string text = read_file(kDs);
  const std::size_t at = text.find("  resolution:");
  ASSERT_NE(at, std::string::npos);
  text.erase(at, text.find('\n', at) + 1 - at);
  const std::string without = folder.write("without.yaml", text);
  EXPECT_EQ(run_program({"compare", kDs, without}).code, 0);
  EXPECT_EQ(run_program({"compare", without, kDs}).code, 0);
  const Told neither({"compare", without, without, "--max-error", "0"});
  EXPECT_EQ(neither.code(), 0) << neither.text();
  EXPECT_TRUE(neither.json()["files"][0]["cameras"][0]["size_assumed"].GetBool()) << neither.text();
  EXPECT_TRUE(neither.json()["files"][0]["identical"].GetBool()) << neither.text();
  const std::string moved =
      folder.write("moved.yaml", with_replaced(read_file(without), "158.28600034966977", "160.28600034966977"));
  EXPECT_TRUE(
      document_of(run_program({"compare", without, moved, "--json"}))["files"][0]["cameras"][0]["size_assumed"].GetBool());
}

TEST(Compare, OtherSizesAreScaledOrRefused) {
  const TemporaryFolder folder;
  const std::string half = folder / "half.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--to", "kalibr", "--resize", "256x256", "-o", half}).code, 0);
  const rapidjson::Document scaled = document_of(run_program({"compare", kTumvi, half, "--json"}));
  EXPECT_LT(scaled["files"][0]["cameras"][0]["error_px"]["max"].GetDouble(), 1e-9);
  EXPECT_EQ(scaled["files"][0]["cameras"][0]["scaled_from_px"][0].GetDouble(), 256.0);
  const std::string cut = folder / "cut.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--to", "kalibr", "--crop", "0,16,512,480", "-o", cut}).code, 0);
  const RunResult refused = run_program({"compare", kTumvi, cut});
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(says(refused.err, "resolution-differs", "--crop")) << refused.err;
  const Told told({"compare", kTumvi, cut, "--crop", "0,16,512,480"});
  EXPECT_EQ(told.code(), 0) << told.text();
  EXPECT_TRUE(told.json()["files"][0]["cameras"][0]["identical"].GetBool()) << told.text();
}

TEST(Compare, CamerasAreMatchedByNameOrAsChosen) {
  const TemporaryFolder folder;
  const std::string second = folder / "second.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--camera", "1", "--to", "orbslam3", "-o", second}).code, 0);
  // Its only camera is called cam0 by itself.
  const Told by_choice({"compare", kTumvi, second, "--camera", "cam1"});
  EXPECT_EQ(by_choice.code(), 0) << by_choice.text();
  EXPECT_TRUE(by_choice.json()["files"][0]["cameras"][0]["identical"].GetBool()) << by_choice.text();
  EXPECT_EQ(run_program({"compare", kTumvi, second, "--camera", "cam7"}).code, 3);
}

TEST(Compare, MistakesAreCalledByName) {
  const TemporaryFolder folder;
  const std::string good = folder / "good.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "--orbslam3-layout", "v1", "-o", good}).code,
            0);
  // The pose as Kalibr has it, where ORB-SLAM3 wants the other direction.
  const std::string text = read_file(good);
  const std::size_t key = text.find("IMU.T_b_c1");
  ASSERT_NE(key, std::string::npos);
  const std::size_t begin = text.find('[', key);
  const std::size_t end = text.find(']', begin);
  const rapidjson::Document shown = document_of(run_program({"show", kTumvi, "--json"}));
  std::string matrix;
  for (const auto& pose : shown["files"][0]["poses"].GetArray()) {
    if (std::string(pose["a"].GetString()) != "cam0" || std::string(pose["b"].GetString()) != "imu0") continue;
    for (const auto& row : pose["T_a_b"].GetArray()) {
      if (!row.IsArray()) {
        matrix += (matrix.empty() ? "" : ", ") + std::to_string(row.GetDouble());
        continue;
      }
      for (const auto& value : row.GetArray()) matrix += (matrix.empty() ? "" : ", ") + std::to_string(value.GetDouble());
    }
  }
  ASSERT_FALSE(matrix.empty());
  const std::string wrong = folder.write("wrong.yaml", text.substr(0, begin + 1) + matrix + text.substr(end));
  const RunResult run = run_program({"compare", kTumvi, "--with", kImu, wrong});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(last_line(run.out).starts_with("verdict: " + wrong + ": IMU.T_b_c1 ")) << run.out;
  const rapidjson::Document document = document_of(run_program({"compare", kTumvi, "--with", kImu, wrong, "--json"}));
  EXPECT_STREQ(document["files"][0]["mistakes"][0]["code"].GetString(), "pose-inverted");
  EXPECT_STREQ(document["files"][0]["mistakes"][0]["subject"].GetString(), "IMU.T_b_c1");
}

// OCamCalib specifies its lens twice. Directions are the direct polynomial's, and world2cam's pixels the inverse one's.
TEST(Compare, AnotherInversePolynomialIsSaid) {
  const TemporaryFolder folder;
  const std::string good = testdata("formats/ocamcalib/good/toolbox.txt");
  const std::string wrong = folder.write("wrong.txt", with_replaced(read_file(good), "19 554.48", "19 559.48"));
  const RunResult run = run_program({"compare", good, wrong});
  EXPECT_EQ(run.code, 0) << run.err;
  // Five pixels more in b0 move every pixel by five.
  EXPECT_TRUE(last_line(run.out).ends_with(" 5 px")) << run.out;
  const rapidjson::Document document = document_of(run_program({"compare", good, wrong, "--json"}));
  EXPECT_FALSE(document["files"][0]["identical"].GetBool());
  EXPECT_NEAR(document["files"][0]["inverse_px"].GetDouble(), 5.0, 1e-2);
  EXPECT_EQ(run_program({"compare", good, wrong, "--max-error", "4"}).code, 1);
  EXPECT_EQ(run_program({"compare", good, wrong, "--max-error", "6"}).code, 0);
  const rapidjson::Document same = document_of(run_program({"compare", good, good, "--json"}));
  EXPECT_TRUE(same["files"][0]["identical"].GetBool());
  EXPECT_EQ(same["files"][0]["inverse_px"].GetDouble(), 0.0);
}

TEST(Compare, AMistakeFailsWithMaxErrorAndAnyOtherPoseOrNumberWithStrict) {
  const TemporaryFolder folder;
  const std::string text = read_file(kDs);
  const auto code = [&](const std::string& from, const std::string& to, const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"compare", kDs, folder.write("other.yaml", with_replaced(text, from, to))};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments).code;
  };
  const std::string x = "-0.10106110275180535";
  const std::string time = "timeshift_cam_imu: 0.0021";
  // Millimetres, and the other sign.
  for (const auto& [from, to] : {std::pair(x, std::string("-101.06")), {time, std::string("timeshift_cam_imu: -0.0021")}}) {
    EXPECT_EQ(code(from, to, {}), 0) << to;
    EXPECT_EQ(code(from, to, {"--max-error", "1"}), 1) << to;
    EXPECT_EQ(code(from, to, {"--strict"}), 1) << to;
  }
  // 1 cm, and 10 ms.
  for (const auto& [from, to] : {std::pair(x, std::string("-0.1111")), {time, std::string("timeshift_cam_imu: 0.0121")}}) {
    EXPECT_EQ(code(from, to, {"--max-error", "1"}), 0) << to;
    EXPECT_EQ(code(from, to, {"--strict"}), 1) << to;
  }
  // 1 mm, 0.2 ms, 0.1 px; and 1 px.
  for (const auto& [from, to] : {std::pair(x, std::string("-0.1021")), {time, std::string("timeshift_cam_imu: 0.0023")}}) {
    EXPECT_EQ(code(from, to, {"--strict"}), 0) << to;
  }
  EXPECT_EQ(code("254.9611", "255.0611", {"--strict"}), 0);
  EXPECT_EQ(code("254.9611", "256.3611", {"--strict"}), 1);
  EXPECT_EQ(code("254.9611", "256.3611", {"--strict", "--max-error", "2"}), 0);
  // What is not said any more.
  EXPECT_EQ(code("  " + time + "\n", "", {"--max-error", "1"}), 0);
  EXPECT_EQ(code("  " + time + "\n", "", {"--strict"}), 1);
}

TEST(Compare, TheSameMistakeIsToldOnce) {
  const TemporaryFolder folder;
  std::string text = read_file(kTumvi);
  for (int i = 0; i < 2; ++i) text = with_replaced(text, "[512, 512]", "[1024, 1024]");
  const std::string wrong = folder.write("wrong.yaml", text);
  const std::string verdict = last_line(run_program({"compare", kTumvi, wrong}).out);
  EXPECT_TRUE(verdict.starts_with("verdict: " + wrong + ": cam0 ")) << verdict;
  EXPECT_TRUE(contains(verdict, "cam1")) << verdict;
}

/// The first line that begins with that word, and where it stands.
struct FoundLine {
  std::size_t number = 0;  ///< From 1; 0: there is none.
  std::string text;
};
FoundLine line_about(const std::string& text, const std::string& word) {
  std::istringstream stream(text);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.find_first_not_of(' ') != std::string::npos && line.substr(line.find_first_not_of(' ')).starts_with(word + " "))
      return {number, line};
  }
  return {};
}

TEST(Compare, AParameterThatDiffersStandsFirstWithItsDifference) {
  const TemporaryFolder folder;
  const std::string wrong =
      folder.write("wrong.yaml", with_replaced(read_file(kTumvi), "190.97847715128717", "191.97847715128717"));
  const RunResult run = run_program({"compare", kTumvi, wrong});
  const FoundLine fx = line_about(run.out, "fx");
  EXPECT_GT(fx.number, 0U) << run.out;
  EXPECT_LE(fx.number, 6U) << run.out;
  EXPECT_TRUE(fx.text.ends_with(" 1")) << fx.text;
  EXPECT_EQ(line_about(run.out, "fy").number, 0U) << "what is the same is not listed";
  const Told told({"compare", kTumvi, wrong});
  const auto& parameters = told.json()["files"][0]["cameras"][0]["parameters"];
  ASSERT_EQ(parameters.Size(), 8U);
  EXPECT_STREQ(parameters[0]["name"].GetString(), "fx");
  EXPECT_NEAR(parameters[0]["value"].GetDouble() - parameters[0]["reference"].GetDouble(), 1.0, 1e-9);
}

// Half the resolution is the same camera: the verdict says both.
TEST(Compare, AnotherResolutionIsAPartOfTheVerdict) {
  const TemporaryFolder folder;
  const std::string half = folder / "half.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--to", "kalibr", "--resize", "256x256", "-o", half}).code, 0);
  const RunResult run = run_program({"compare", kTumvi, half});
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* size : {"256 x 256", "512 x 512"}) EXPECT_TRUE(contains(last_line(run.out), size)) << run.out;
}

/// A Kalibr file of one camera.
std::string chain(const char* model, const char* intrinsics, const char* distortion, const char* coefficients,
                  const char* size) {
  return std::string("cam0:\n  camera_model: ") + model + "\n  intrinsics: [" + intrinsics +
         "]\n  distortion_model: " + distortion + "\n  distortion_coeffs: [" + coefficients + "]\n  resolution: [" + size +
         "]\n  rostopic: /cam0\n";
}

/// The largest number in front of " px".
double largest_px(const std::string& text) {
  double largest = 0.0;
  for (std::size_t at = text.find(" px"); at != std::string::npos; at = text.find(" px", at + 1)) {
    const std::size_t begin = text.find_last_of(" (\n", at - 1) + 1;
    largest = std::max(largest, std::atof(text.substr(begin, at - begin).c_str()));
  }
  return largest;
}

// A mirror's numbers without its xi, and a fisheye's under the name of a mirror's: the distances are then beyond any image.
TEST(Compare, NumbersUnderAnotherModelsNameAreRecognisedAndNoDistanceIsLargerThanTheImage) {
  const TemporaryFolder folder;
  const char* const size = "1400, 1400";
  const std::string mei = folder.write("mei.yaml", chain("omni", "2.2134047, 1336.3220, 1335.7883, 716.9432, 705.7645",
                                                         "radtan", "0.016798, 1.6548, 0.00042, 0.00042", size));
  const std::string plumb_bob = folder.write("plumb_bob.yaml", chain("pinhole", "1336.3220, 1335.7883, 716.9432, 705.7645",
                                                                     "radtan", "0.016798, 1.6548, 0.00042, 0.00042", size));
  const std::string fisheye = folder.write("fisheye.yaml", chain("pinhole", "1336.3220, 1335.7883, 716.9432, 705.7645",
                                                                 "equidistant", "0.016798, 1.6548, 0.00042, 0.00042", size));
  for (const std::string& wrong : {plumb_bob, fisheye}) {
    for (const auto& [reference, other] : {std::pair(mei, wrong), std::pair(wrong, mei)}) {
      SCOPED_TRACE(reference + " and " + other);
      const Told told({"compare", reference, other});
      const auto& mistakes = told.json()["files"][0]["mistakes"];
      ASSERT_EQ(mistakes.Size(), 1U) << told.text();
      EXPECT_STREQ(mistakes[0]["code"].GetString(), "wrong-model");
      const RunResult run = run_program({"compare", reference, other, "-v"});
      const double diagonal = std::ceil(std::hypot(1400.0, 1400.0));
      EXPECT_LE(largest_px(run.out), diagonal) << run.out;
      const auto& camera = told.json()["files"][0]["cameras"][0];
      const auto is_held = [diagonal](const auto& px) { return !px.IsNumber() || px.GetDouble() <= diagonal; };
      ASSERT_TRUE(camera["error_px"].IsObject()) << told.text();
      for (const char* key : {"rms", "p99", "max", "bound"}) EXPECT_TRUE(is_held(camera["error_px"][key])) << told.text();
      for (const auto& band : camera["bands"].GetArray()) EXPECT_TRUE(is_held(band["max_px"])) << told.text();
    }
  }
}

TEST(Compare, TheDocumentHasItsKeys) {
  const RunResult run = run_program({"compare", kTumvi, kDs, kOrbslam3, "--json"});
  const rapidjson::Document document = document_of(run);
  for (const char* key : {"fca_io", "reference", "format", "files", "diagnostics"}) EXPECT_TRUE(document.HasMember(key)) << key;
  for (const auto& file : document["files"].GetArray()) {
    for (const char* key : {"file", "format", "exit_code", "verdict", "identical", "mistakes", "cameras", "poses", "numbers",
                            "only_in_reference", "only_in_file", "diagnostics"})
      EXPECT_TRUE(file.HasMember(key)) << key;
    EXPECT_GT(file["verdict"].GetStringLength(), 0U);
    for (const auto& camera : file["cameras"].GetArray()) {
      for (const char* key : {"name", "other_name", "from_model", "to_model", "image_size_px", "scaled_from_px", "identical",
                              "domain", "error_px", "error_deg", "bands", "same_to_deg", "rotated"})
        EXPECT_TRUE(camera.HasMember(key)) << key;
    }
  }
}

}  // namespace
}  // namespace fca::test
