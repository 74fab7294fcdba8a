// SPDX-License-Identifier: BSD-3-Clause
// The command around the checks: what it prints where, its exit codes, folders, --fix, and its documents.
#include "cli/run_program.h"
#include "cli/told.h"
#include "commands/check/explain/stories.h"

#include <fca/code.h>
#include <fca/formats/check.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <set>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

std::string check_file(const std::string& name) { return testdata("checks/" + name); }

TEST(Check, ExitCodesSayWhatWasFound) {
  EXPECT_EQ(run_program({"check", check_file("clean.yaml")}).code, 0);
  EXPECT_EQ(run_program({"check", check_file("int-for-real.yaml")}).code, 1);
  const std::string warned = check_file("centre-off.yaml");
  EXPECT_EQ(run_program({"check", warned}).code, 0);
  EXPECT_EQ(run_program({"check", warned, "--fail-on", "warning"}).code, 1);
  EXPECT_EQ(run_program({"check", warned, "--fail-on", "warning", "--ignore", "centre-off"}).code, 0);
  EXPECT_EQ(run_program({"check", warned, "--fail-on", "nothing"}).code, 3);
  EXPECT_EQ(run_program({"check"}).code, 3);
  const TemporaryFolder folder;
  EXPECT_EQ(run_program({"check", folder / "missing.yaml"}).code, 4);
  const RunResult other = run_program({"check", folder.write("other.yaml", "a: 1\n")});
  EXPECT_EQ(other.code, 2);
  EXPECT_EQ(other.out, "");
  EXPECT_TRUE(says(other.err, "unknown-format")) << other.err;
}

TEST(Check, AFindingHasItsPlaceConsequenceAndFix) {
  const RunResult run = run_program({"check", check_file("int-for-real.yaml")});
  EXPECT_TRUE(contains(run.out, "int-for-real.yaml:6:16: error: ")) << run.out;
  EXPECT_TRUE(contains(run.out, "\n                   ^~~\n")) << run.out;
  EXPECT_TRUE(says(run.out, "int-for-real", "458.0")) << run.out;
  EXPECT_EQ(run.err, "");
}

TEST(Check, AnImageOfOnePixelIsComparedWithNothing) {
  const TemporaryFolder folder;
  const std::string one = folder.write("one.yaml",
                                       "cam0:\n  camera_model: pinhole\n  intrinsics: [300.0, 300.0, 0.0, 0.0]\n"
                                       "  distortion_model: equidistant\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n"
                                       "  resolution: [1, 1]\n");
  const RunResult run = run_program({"check", one});
  EXPECT_FALSE(contains(run.out + run.err, "nan")) << run.out;
}

TEST(Check, FoldersAreWalkedAndOtherFilesCounted) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "inner" / ".hidden");
  const std::string good = read_file(check_file("clean.yaml"));
  folder.write("a.yaml", good);
  folder.write("inner/b.yaml", good);
  folder.write("inner/.hidden/c.yaml", good);
  folder.write("notes.txt", "nothing of the kind\n");
  folder.write("package.json", "{\"name\": \"x\"}\n");
  folder.write("program.cc", "int main() {}\n");
  const Told run({"check", folder.path().string()});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_EQ(run.json()["skipped"].Size(), 2U) << run.text();
  const auto& files = run.json()["files"];
  EXPECT_EQ(files.Size(), 2U) << run.text();
  for (const auto& file : files.GetArray()) EXPECT_TRUE(file["findings"].Empty()) << run.text();
}

TEST(Check, ExplainsEveryCodeItLists) {
  const RunResult list = run_program({"check", "--list-codes"});
  EXPECT_EQ(list.code, 0);
  std::size_t codes = 0;
  for (std::size_t at = 0; at < list.out.size(); at = list.out.find('\n', at) + 1) {
    const std::string code = list.out.substr(at, list.out.find(' ', at) - at);
    ++codes;
    if (codes % 8 != 0) continue;  // a run each takes its time
    const RunResult story = run_program({"check", "--explain", code});
    EXPECT_EQ(story.code, 0) << code;
    EXPECT_TRUE(story.out.starts_with(code + ": ")) << story.out;
  }
  EXPECT_GT(codes, 60U);
  // What convert prints in brackets, too: one in eight.
  std::set<std::string_view> others;
  for (const CodeInfo& code : all_codes()) {
    if (find_check_code(code.id) == nullptr && find_code(code.id) != nullptr) others.insert(code.id);
  }
  for (const char* id : {"pixels-off", "no-right-rays", "poor-fit", "target-cannot-reach"})
    EXPECT_TRUE(others.contains(id)) << id;
  std::size_t number = 0;
  for (const std::string_view id : others) {
    if (number++ % 8 != 0 && id != "pixels-off") continue;
    const RunResult said = run_program({"check", "--explain", std::string(id)});
    EXPECT_EQ(said.code, 0) << id;
    EXPECT_TRUE(said.out.starts_with(std::string(id) + ": ")) << said.out;
    for (const char* place : {"{0", "{1", "{2", "{3"}) EXPECT_FALSE(contains(said.out, place)) << said.out;
  }
  EXPECT_EQ(run_program({"check", "--explain", "clause"}).code, 3);
  const RunResult unknown = run_program({"check", "--explain", "pose-invertd"});
  EXPECT_EQ(unknown.code, 3);
  EXPECT_TRUE(contains(unknown.err, "pose-inverted")) << unknown.err;
}

TEST(Check, HasAStoryForEveryCode) {
  std::set<std::string_view> told;
  for (const cli::Story& story : cli::stories()) {
    EXPECT_GT(story.text.size(), 40U) << story.code;
    EXPECT_NE(find_code(story.code), nullptr) << story.code;
    told.insert(story.code);
  }
  for (const CodeInfo& code : check_codes()) EXPECT_TRUE(told.contains(code.id)) << code.id;
  for (const std::string_view code : told) EXPECT_FALSE(cli::story_of(code).empty()) << code;
  EXPECT_EQ(cli::story_of("no-such-code"), "");
}

// The library names the fact that is missing; the command names the option that tells it.
TEST(Check, NamesTheOptionsThatAnswerItsQuestions) {
  const TemporaryFolder folder;
  const std::string good = read_file(check_file("clean.yml"));
  const std::string path =
      folder.write("no-size.yml", with_replaced(with_replaced(good, "image_width: 752\n", ""), "image_height: 480\n", ""));
  const Told no_size({"check", path});
  const auto undecided = no_size.json()["files"][0]["undecided"].GetArray();
  EXPECT_TRUE(std::ranges::any_of(undecided, [](const auto& each) { return contains(each["why"].GetString(), "--size WxH"); }))
      << no_size.text();
  const std::string chain = check_file("clean.yaml");
  const Told other({"check", chain, "--for", "orbslam3"});
  const auto& finding = other.json()["files"][0]["findings"][0];
  EXPECT_STREQ(finding["code"].GetString(), "program-other-format");
  EXPECT_EQ(finding["fix"].GetString(), "fca-io convert " + chain + " --to orbslam3 -o OUT.yaml") << other.text();
  const Told json({"check", chain, "--for", "instant-ngp"});
  EXPECT_TRUE(std::string_view(json.json()["files"][0]["findings"][0]["fix"].GetString()).ends_with(" -o OUT.json"))
      << json.text();
  const RunResult unknown = run_program({"check", folder.write("other.yaml", "a: 1\n")});
  EXPECT_TRUE(says(unknown.err, "unknown-format", "--from FORMAT")) << unknown.err;
}

TEST(Check, JsonIsTheContract) {
  const RunResult run = run_program({"check", check_file("int-for-real.yaml"), check_file("clean.yml"), "--json"});
  EXPECT_EQ(run.code, 1);
  rapidjson::Document document;
  document.Parse(run.out.c_str());
  ASSERT_FALSE(document.HasParseError()) << run.out;
  ASSERT_EQ(document["files"].Size(), 2U);
  const auto& file = document["files"][0];
  EXPECT_STREQ(file["format"].GetString(), "kalibr");
  ASSERT_EQ(file["findings"].Size(), 1U);
  const auto& finding = file["findings"][0];
  EXPECT_STREQ(finding["severity"].GetString(), "error");
  EXPECT_STREQ(finding["code"].GetString(), "int-for-real");
  EXPECT_EQ(finding["line"].GetInt(), 6);
  EXPECT_EQ(finding["column"].GetInt(), 16);
  for (const char* key : {"message", "consequence", "fix"}) EXPECT_GT(finding[key].GetStringLength(), 0U) << key;
  EXPECT_GT(document["files"][1]["checked"].Size(), 2U);
  EXPECT_TRUE(document["files"][1]["undecided"].IsArray());
}

TEST(Check, SarifHasRulesAndPlaces) {
  const RunResult run = run_program({"check", check_file("pose-inverted.yaml"), "--sarif"});
  rapidjson::Document document;
  document.Parse(run.out.c_str());
  ASSERT_FALSE(document.HasParseError()) << run.out;
  EXPECT_STREQ(document["version"].GetString(), "2.1.0");
  const auto& sarif = document["runs"][0];
  ASSERT_EQ(sarif["results"].Size(), 1U);
  const auto& result = sarif["results"][0];
  EXPECT_STREQ(result["ruleId"].GetString(), sarif["tool"]["driver"]["rules"][0]["id"].GetString());
  EXPECT_STREQ(result["level"].GetString(), "error");
  const auto& region = result["locations"][0]["physicalLocation"]["region"];
  EXPECT_EQ(region["startLine"].GetInt(), 23);
  EXPECT_EQ(region["startColumn"].GetInt(), 6);
}

TEST(Check, FixShowsAndWritesOnlyWhenAsked) {
  const TemporaryFolder folder;
  std::string text = read_file(check_file("opencv-header.yaml"));
  text = with_replaced(text, "458.654, 457.296", "458, 457");
  text = with_replaced(text, "1.76187114e-05", "2e-05");
  const std::string path = folder.write("chain.yaml", text);
  const RunResult shown = run_program({"check", "--fix", path});
  EXPECT_EQ(shown.code, 1) << shown.out;
  EXPECT_EQ(read_file(path), text);
  EXPECT_TRUE(contains(shown.out, "- %YAML:1.0\n+ %YAML 1.2\n+ ---\n")) << shown.out;
  EXPECT_TRUE(contains(shown.out, "+   intrinsics: [458.0, 457.0, 367.215, 248.375]\n")) << shown.out;
  EXPECT_EQ(run_program({"check", "--fix", "--write", path}).code, 0);
  std::string expected = with_replaced(text, "%YAML:1.0\n", "%YAML 1.2\n---\n");
  expected = with_replaced(with_replaced(expected, "458, 457", "458.0, 457.0"), "2e-05", "2.0e-05");
  EXPECT_EQ(read_file(path), expected);
  EXPECT_EQ(run_program({"check", path}).code, 0);
  // What needs a person's decision stays.
  const std::string inverted = folder.write("inverted.yaml", read_file(check_file("pose-inverted.yaml")));
  EXPECT_EQ(run_program({"check", "--fix", "--write", inverted}).code, 1);
  EXPECT_EQ(read_file(inverted), read_file(check_file("pose-inverted.yaml")));
  EXPECT_EQ(run_program({"check", "--write", path}).code, 3);
}

TEST(Check, ForAnotherProgram) {
  const std::string orbslam2 = check_file("read-by-another.yaml");
  EXPECT_EQ(run_program({"check", orbslam2}).code, 0);
  EXPECT_EQ(run_program({"check", orbslam2, "--for", "ORB_SLAM3"}).code, 1);
  EXPECT_EQ(run_program({"check", orbslam2, "--for", "orbslam2"}).code, 0);
  // Kalibr has a reader for each of its files.
  EXPECT_EQ(run_program({"check", check_file("clean-imu.yaml"), "--for", "kalibr"}).code, 0);
  EXPECT_EQ(run_program({"check", check_file("clean.yaml"), "--for", "kalibr-imu"}).code, 1) << "it has no noise";
  EXPECT_EQ(run_program({"check", orbslam2, "--for", "orbslam4"}).code, 3);
}

// A program of another format: what it would be given, from convert itself.
TEST(Check, ForAProgramOfAnotherFormat) {
  const std::string chain = check_file("clean-pair.yaml");
  const RunResult run = run_program({"check", chain, "--for", "orbslam3", "--json"});
  EXPECT_EQ(run.code, 1);
  rapidjson::Document checked;
  checked.Parse(run.out.c_str());
  ASSERT_FALSE(checked.HasParseError()) << run.out;
  const auto& file = checked["files"][0];
  EXPECT_STREQ(file["findings"][0]["code"].GetString(), "program-other-format");
  ASSERT_TRUE(file.HasMember("conversion")) << run.out;
  rapidjson::Document converted;
  const RunResult convert = run_program({"convert", chain, "--to", "orbslam3", "--dry-run", "--json"});
  converted.Parse(convert.out.c_str());
  ASSERT_FALSE(converted.HasParseError()) << convert.out;
  for (const char* key : {"losses", "defaults", "proof"}) EXPECT_EQ(file["conversion"][key], converted[key]) << key;
  EXPECT_GT(converted["losses"].Size() + converted["defaults"].Size(), 0U);
  EXPECT_EQ(file["conversion"]["headline"], converted["headline"]);
  const RunResult text = run_program({"check", chain, "--for", "orbslam3"});
  for (const char* value : {"ORB-SLAM3 V1.0", "Camera.fps 20", "Camera.RGB 1"})
    EXPECT_TRUE(contains(text.out, value)) << value << " is not in\n" << text.out;
  // What convert cannot write is said with its reason.
  const Told imu({"check", check_file("clean-imu.yaml"), "--for", "opencv"});
  EXPECT_EQ(imu.code(), 1);
  const auto& refused = imu.json()["files"][0]["conversion"];
  EXPECT_EQ(refused["exit_code"].GetInt(), 2) << imu.text();
  EXPECT_STREQ(refused["diagnostics"][0]["code"].GetString(), "no-camera") << imu.text();
}

// A configuration is as good as the camera files that it names: each is looked for, and checked as a file of its own.
TEST(Check, FilesThatAConfigurationNamesAreCheckedWithIt) {
  const std::string config = read_file(testdata("formats/vins/good/config.yaml"));
  const std::string camera = read_file(testdata("formats/vins/good/kannala-brandt.yaml"));
  const TemporaryFolder folder;
  const std::string file = folder.write("config.yaml", config);
  const RunResult alone = run_program({"check", file});
  EXPECT_EQ(alone.code, 1);
  EXPECT_TRUE(says(alone.out, "part-missing", "config.yaml:13:13: error")) << alone.out;
  EXPECT_TRUE(says(alone.out, "part-missing", folder / "cam0.yaml")) << alone.out;

  folder.write("cam0.yaml", camera);
  folder.write("cam1.yaml", with_replaced(camera, "k2: ", "k2: x"));
  const RunResult both = run_program({"check", file});
  EXPECT_EQ(both.code, 1);
  EXPECT_FALSE(says(both.out, "part-missing")) << both.out;
  EXPECT_TRUE(contains(both.out, (folder / "cam0.yaml") + ": ")) << both.out;
  EXPECT_TRUE(says(both.out, "not-a-number")) << both.out;
  // Each once, however they are named.
  const RunResult walked = run_program({"check", folder.path().string(), file});
  EXPECT_EQ(numbers_of_last_line(walked.out).at(0), 3) << walked.out;

  folder.write("cam1.yaml", with_replaced(camera, "image_width: ", "image_width: 1"));
  const RunResult other_size = run_program({"check", file});
  EXPECT_TRUE(says(other_size.out, "size-contradicts", "config.yaml:15:14: warning")) << other_size.out;

  folder.write("cam1.yaml", config);
  const RunResult itself = run_program({"check", file});
  EXPECT_TRUE(says(itself.out, "no-calibration")) << itself.out;
}

TEST(Check, ReadsStandardInput) {
  const RunResult run = run_program({"check", "-"}, {.input = read_file(check_file("int-for-real.yaml"))});
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(says(run.out, "int-for-real", "<stdin>:6:16: error")) << run.out;
}

// What converting a pair to a format of one camera would cost, too.
TEST(Check, ForAFormatOfOneCameraEachIsPriced) {
  const std::string pair = testdata("formats/kalibr/good/tumvi.yaml");
  const Told run({"check", pair, "--for", "ocamcalib"});
  EXPECT_EQ(run.code(), 1);
  const auto& checked = run.json()["files"][0];
  EXPECT_EQ(checked["findings"][0]["fix"].GetString(), "fca-io convert " + pair + " --to ocamcalib -o FOLDER/") << run.text();
  const auto& cameras = checked["conversion"]["cameras"];
  ASSERT_EQ(cameras.Size(), 2U) << run.text();
  const std::string text = run_program({"check", pair, "--for", "ocamcalib"}).out;
  for (const auto& camera : cameras.GetArray()) {
    EXPECT_STREQ(camera["from_model"].GetString(), "kb4");
    EXPECT_STREQ(camera["to_model"].GetString(), "ocamcalib");
    EXPECT_FALSE(camera["exact"].GetBool());
    EXPECT_GT(camera["error_px"]["rms"].GetDouble(), 0.0);
    EXPECT_TRUE(contains(text, camera["name"].GetString())) << text;
  }
  // However long its path is, the command is there to be copied: in one line, and blanks in quotes.
  const TemporaryFolder folder;
  const std::string file =
      folder.write("my files " + std::string(90, 'x') + ".yaml", read_file(testdata("formats/kalibr/good/tumvi.yaml")));
  const RunResult elsewhere = run_program({"check", file, "--for", "ocamcalib"});
  EXPECT_TRUE(contains(elsewhere.out, "fca-io convert '" + file + "' --to ocamcalib -o FOLDER/\n")) << elsewhere.out;
}

}  // namespace
}  // namespace fca::test
