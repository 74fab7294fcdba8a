// SPDX-License-Identifier: BSD-3-Clause
// What users are told first, on real files of the corpus (skipped without it) and on files written here.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"
#include "shell/verdict_text.h"

#include <fca/code.h>
#include <fca/formats/consumers/consumer.h>
#include <fca/formats/text/message.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace fca::test {
namespace {

/// A file of the corpus; empty where it is not there.
std::string corpus(const std::string& name) {
  const fs::path path = fs::path(FCA_SHARED_DIR) / "corpus" / name;
  return fs::exists(path) ? path.string() : std::string();
}

std::size_t lines_in(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) longest = std::max(longest, line.size());
  return longest;
}

/// The word of a run with --json.
std::string word_of(const Told& run) { return run.json()["verdict"]["word"].GetString(); }

std::set<std::string> codes_of(const Told& run) {
  std::set<std::string> codes;
  for (const auto& reason : run.json()["verdict"]["reasons"].GetArray()) codes.insert(reason["code"].GetString());
  return codes;
}

const std::string kT265 = "kalibr/rpng__open_vins__config__rs_t265__kalibr_imucam_chain.yaml";
const std::string kT265Imu = "kalibr/rpng__open_vins__config__rs_t265__kalibr_imu_chain.yaml";
const std::string kEuroc = "kalibr/rpng__open_vins__config__euroc_mav__kalibr_imucam_chain.yaml";
const std::string kEurocImu = "kalibr/rpng__open_vins__config__euroc_mav__kalibr_imu_chain.yaml";

TEST(VerdictFirst, AFisheyePairGetsTheLayoutThatTheProgramReadsRightly) {
  const std::string chain = corpus(kT265);
  if (chain.empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const std::vector<std::string> words = {"convert", chain, "--with", corpus(kT265Imu), "--to", "orbslam3"};
  const Told run(words);
  EXPECT_EQ(run.code(), 0) << run.text();
  const consumers::ConsumerView view = consumers::find_consumer("orbslam3")->load(run.bytes(), {"stereo-inertial"});
  ASSERT_EQ(view.cameras.size(), 2U) << run.text();
  const Rig rig = rig_in(read_file(chain));
  for (std::size_t i = 0; i < 2; ++i) {
    int compared = 0;
    for (double u = 24.0; u < 848.0; u += 40.0) {
      for (double v = 20.0; v < 800.0; v += 40.0) {
        const std::optional<Ray> ray = unproject(rig.cameras[i].model, {u, v});
        if (!ray || (*ray)[2] <= 0.0) continue;
        const auto theirs = view.cameras[i].project(*ray);
        ASSERT_TRUE(theirs);
        EXPECT_NEAR((*theirs)[0], u, 0.001);
        EXPECT_NEAR((*theirs)[1], v, 0.001);
        ++compared;
      }
    }
    EXPECT_GT(compared, 300);
  }
  // For whom, which layout, and whether to use it.
  const RunResult text = run_program(words, {.in_full = false});
  std::string first = text.err.substr(0, text.err.find("cam0"));
  while (contains(first, "\n  ")) first = with_replaced(first, "\n  ", " ");
  EXPECT_TRUE(contains(first, text::text_of({Code::kOrbslam3StyleBefore, {"ORB-SLAM3 V1.0"}}))) << text.err;
  EXPECT_TRUE(contains(text.err, "--orbslam3-layout v1")) << text.err;
  const VerdictWord word = word_of(run) == "ready" ? VerdictWord::kReady : VerdictWord::kUseWithCare;
  EXPECT_EQ(word_of(run), name_of(word));
  EXPECT_TRUE(contains(first, std::string(cli::in_words(word)))) << text.err;
  EXPECT_LE(lines_in(text.err), 10U) << text.err;
  EXPECT_LE(longest_line(text.err), 80U) << text.err;
}

// Corners beyond the lens do not decide: inside the circle these models fit, if nothing else is asked of them.
TEST(VerdictFirst, ModelsOfAWideLensAreRankedInsideTheCircle) {
  const std::string chain = corpus(kT265);
  if (chain.empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const Told run({"models", chain, "--camera", "0"});
  EXPECT_EQ(run.json()["cameras"][0]["recommended"].GetString(), std::string("kb4"));
  std::map<std::string, double> decisive;
  std::string angle;
  for (const auto& target : run.json()["cameras"][0]["targets"].GetArray()) {
    if (!target["fits"].GetBool() || !target["reaches_all"].GetBool()) continue;
    decisive[target["model"].GetString()] = target["decisive_rms_px"].GetDouble();
    if (target.HasMember("decisive_with_max_angle_deg"))
      angle = std::to_string(static_cast<int>(target["decisive_with_max_angle_deg"].GetDouble()));
    if (target["model"].GetString() == std::string("eucm")) {
      EXPECT_GT(target["rms_px"].GetDouble(), 5.0) << "the whole image is a note";
    }
  }
  EXPECT_LT(decisive.at("mei"), 0.25);
  EXPECT_LT(decisive.at("eucm"), 0.5);
  EXPECT_LT(decisive.at("mei"), decisive.at("eucm"));
  // And that is what one gets: without the angle a file that is not to be used, with the angle that its fix names.
  const std::vector<std::string> words = {"convert", chain, "--camera", "0", "--to", "kalibr", "--model", "eucm"};
  const Told whole(words);
  EXPECT_EQ(word_of(whole), "do-not-use") << whole.text();
  EXPECT_TRUE(contains(whole.json()["verdict"]["reasons"][0]["fix"].GetString(), "--max-angle " + angle)) << whole.text();
  std::vector<std::string> inside = words;
  inside.insert(inside.end(), {"--max-angle", angle});
  const Told circle(inside);
  EXPECT_NE(word_of(circle), "do-not-use") << circle.text();
  EXPECT_NEAR(circle.json()["verdict"]["reasons"][0]["rms_px"].GetDouble(), decisive.at("eucm"), 0.05);
}

// A model of the user's leaves the choice of the layout free.
TEST(VerdictFirst, TheLayoutIsChosenForAGivenModelToo) {
  const std::string chain = corpus(kT265);
  if (chain.empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const RunResult free = run_program({"convert", chain, "--to", "orbslam3", "--no-provenance"});
  const RunResult asked = run_program({"convert", chain, "--to", "orbslam3", "--model", "kb4", "--no-provenance"});
  EXPECT_EQ(asked.code, 0);
  EXPECT_EQ(asked.out, free.out);
}

TEST(VerdictFirst, AMisreadPinholePairIsUsedWithCareAndBothLayoutsAreShown) {
  const std::string chain = corpus(kEuroc);
  if (chain.empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const std::vector<std::string> words = {"convert", chain, "--with", corpus(kEurocImu), "--to", "orbslam3"};
  const Told run(words);
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_EQ(word_of(run), "use-with-care") << run.text();
  // Both layouts with their numbers. V1.0 misreads one camera by 1.5 px at worst; the other layout has another model, which
  // costs both cameras more at worst: no fix that makes that worse.
  ASSERT_GE(run.json()["other_writings"].Size(), 1U);
  const auto& other = run.json()["other_writings"][0];
  const auto& reasons = run.json()["verdict"]["reasons"];
  ASSERT_FALSE(reasons.Empty());
  EXPECT_LT(reasons[0]["rms_px"].GetDouble(), 0.25);
  EXPECT_GT(other["max_px"].GetDouble(), 1.9);
  for (const auto& reason : reasons.GetArray()) {
    const std::string fix = reason["fix"].IsString() ? reason["fix"].GetString() : "";
    EXPECT_FALSE(contains(fix, other["layout"].GetString())) << run.text();
  }
  const RunResult text = run_program(words, {.in_full = false});
  EXPECT_LE(lines_in(text.err), 10U) << text.err;
  EXPECT_TRUE(contains(text.err, other["layout"].GetString())) << text.err;
}

// Whatever two cameras become: ten lines of 80 columns, but for paths.
TEST(VerdictFirst, TwoCamerasTakeTenLines) {
  if (corpus(kT265).empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string() + "/";
  // With an IMU files of one camera lose more than ten lines tell.
  for (const auto& [chain, imu] : {std::pair(corpus(kT265), corpus(kT265Imu)), std::pair(corpus(kEuroc), std::string())}) {
    const std::string input = folder.write("chain.yaml", read_file(chain));
    for (const Format& format : written_formats()) {
      std::vector<std::string> words = {"convert", input, "--to", std::string(format.id), "-o", out, "--force"};
      if (!imu.empty() && format.id != "vins" && format.id != "fast-livo") words.insert(words.end(), {"--with", imu});
      const RunResult run = run_program(words, {.in_full = false});
      EXPECT_FALSE(run.out.empty()) << format.id << run.err;
      // A lens that the target cannot reach takes four more.
      const std::size_t most = contains(run.out, "cannot describe") ? 14U : 10U;
      EXPECT_LE(lines_in(run.out), most) << run.out;
      EXPECT_LE(longest_line(run.out.substr(run.out.find('\n') + 1)), 80U) << run.out;
    }
  }
}

TEST(VerdictFirst, AWrongImageSizeIsNotWritten) {
  const std::string pair = corpus("opencv/sourishg__jackal-navigation__src__calibration__stereo_calib.yml");
  if (pair.empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const TemporaryFolder folder;
  const std::vector<std::string> words = {"convert", pair, "--size", "640x360", "--to", "kalibr", "-o", folder / "out.yaml"};
  const Told run(words);
  EXPECT_EQ(run.code(), 1) << run.text();
  EXPECT_TRUE(codes_of(run).contains("size-unlike-centre")) << run.text();
  EXPECT_TRUE(folder.names().empty());
  EXPECT_EQ(run.json()["refused_outputs"].Size(), 1U);
  std::vector<std::string> accepted = words;
  accepted.insert(accepted.end(), {"--accept", "size-unlike-centre"});
  EXPECT_EQ(run_program(accepted).code, 0);
  EXPECT_EQ(folder.names(), std::set<std::string>{"out.yaml"});
}

// A board in millimetres makes a baseline of 139 m.
TEST(VerdictFirst, MillimetresAreNotWrittenAsMetres) {
  const std::string pair = corpus("opencv/kev1nCh1u__opencv_practice__param__intrinsics.yml");
  if (pair.empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const TemporaryFolder folder;
  const std::string pose = corpus("opencv/kev1nCh1u__opencv_practice__param__extrinsics.yml");
  const std::vector<std::string> words = {"convert", pair,   "--with", pose, "--size",
                                          "640x480", "--to", "kalibr", "-o", folder / "out.yaml"};
  const Told run(words);
  EXPECT_EQ(run.code(), 1) << run.text();
  EXPECT_EQ(word_of(run), "do-not-use");
  EXPECT_TRUE(codes_of(run).contains("units-not-stated")) << run.text();
  EXPECT_TRUE(folder.names().empty());
  const RunResult text = run_program(words, {.in_full = false});
  EXPECT_TRUE(contains(text.err + text.out, "--accept units-not-stated")) << text.err;
  std::vector<std::string> in_millimetres = words;
  in_millimetres.insert(in_millimetres.end(), {"--unit", "mm"});
  const Told told(in_millimetres);
  EXPECT_EQ(told.code(), 0) << told.text();
  EXPECT_FALSE(codes_of(told).contains("units-not-stated")) << told.text();
  const std::optional<Transform> T = rig_in(read_file(folder / "out.yaml")).resolve("cam1", "cam0");
  ASSERT_TRUE(T);
  EXPECT_NEAR((*T)(0, 3), -0.13966910518406266, 1e-12);
}

TEST(VerdictFirst, CamerasAtRightAnglesAreNoPair) {
  const std::string rig = corpus("kalibr/ethz-asl__rovio__cfg__calibration.yaml");
  if (rig.empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const Told run({"convert", rig, "--to", "orbslam3"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_EQ(run.json()["cameras"].Size(), 1U) << run.text();
  const RunResult text = run_program({"convert", rig, "--to", "orbslam3"}, {.in_full = false});
  for (const char* camera : {"cam1", "cam2", "cam3", "cam4"}) EXPECT_TRUE(contains(text.err, camera)) << text.err;
}

/// Three cameras: the second looks backwards, the first and the third are a pair.
std::string chain_of_three() {
  const auto camera = [](int index, const std::string& pose) {
    return "cam" + std::to_string(index) +
           ":\n  camera_model: pinhole\n  intrinsics: [400.0, 400.0, 319.5, 239.5]\n  distortion_model: radtan\n"
           "  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n  resolution: [640, 480]\n" +
           pose;
  };
  const std::string turned =
      "  T_cn_cnm1:\n  - [-1.0, 0.0, 0.0, 0.0]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, -1.0, 0.0]\n  - [0.0, 0.0, 0.0, "
      "1.0]\n";
  const std::string back =
      "  T_cn_cnm1:\n  - [-1.0, 0.0, 0.0, -0.1]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, -1.0, 0.0]\n  - [0.0, 0.0, 0.0, "
      "1.0]\n";
  return camera(0, "") + camera(1, turned) + camera(2, back);
}

TEST(VerdictFirst, ThePairIsTheTwoThatSeeTheSame) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("three.yaml", chain_of_three());
  const Told run({"convert", chain, "--to", "orbslam3"});
  ASSERT_EQ(run.json()["cameras"].Size(), 2U) << run.text();
  EXPECT_STREQ(run.json()["cameras"][0]["input_name"].GetString(), "cam0");
  EXPECT_STREQ(run.json()["cameras"][1]["input_name"].GetString(), "cam2");
  // A choice of the user's stays.
  const Told chosen({"convert", chain, "--camera", "0,1", "--to", "orbslam3", "--sensor", "stereo"});
  EXPECT_STREQ(chosen.json()["cameras"][1]["input_name"].GetString(), "cam1");
  EXPECT_TRUE(codes_of(chosen).contains("no-common-view")) << chosen.text();
  EXPECT_FALSE(codes_of(run).contains("no-common-view")) << run.text();
}

// Kimera-VIO reads two files by their names, and nothing asks whether their cameras see the same.
TEST(VerdictFirst, ThePairOfNamedFilesIsTheTwoThatSeeTheSame) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("three.yaml", chain_of_three());
  const std::string out = (folder.path() / "out").string() + "/";
  const Told run({"convert", chain, "--to", "kimera", "-o", out});
  EXPECT_TRUE(contains(read_file(out + "LeftCameraParams.yaml"), "camera_id: \"cam0\"")) << run.text();
  EXPECT_TRUE(contains(read_file(out + "RightCameraParams.yaml"), "camera_id: \"cam2\"")) << run.text();
  // Two that look away from each other are no pair, whoever chose them.
  const std::string other = (folder.path() / "other").string() + "/";
  const Told chosen({"convert", chain, "--camera", "0,1", "--to", "kimera", "-o", other});
  EXPECT_FALSE(fs::exists(other + "RightCameraParams.yaml")) << chosen.text();
  EXPECT_TRUE(fs::exists(other + "cam1CameraParams.yaml")) << chosen.text();
}

// Whichever way a file specifies them: by poses between cameras or by each camera's in the IMU.
TEST(VerdictFirst, LostPosesBetweenCamerasMatter) {
  const TemporaryFolder folder;
  const std::string between = folder.write("between.yaml", chain_of_three());
  std::string in_imu = chain_of_three();
  for (const char* pose : {"cam0:\n", "T_cn_cnm1"}) {
    const bool is_first = std::string_view(pose) != "T_cn_cnm1";
    const std::string identity =
        "  T_cam_imu:\n  - [1.0, 0.0, 0.0, 0.0]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, "
        "1.0]\n";
    if (is_first) {
      in_imu.insert(in_imu.find(pose) + 6, identity);
    } else {
      for (std::size_t at = in_imu.find(pose); at != std::string::npos; at = in_imu.find(pose))
        in_imu.replace(at, 9, "T_cam_imu");
    }
  }
  const std::string by_imu = folder.write("in_imu.yaml", in_imu);
  const std::string first = word_of(Told({"convert", between, "--to", "ros", "-o", (folder.path() / "a").string() + "/"}));
  const std::string second = word_of(Told({"convert", by_imu, "--to", "ros", "-o", (folder.path() / "b").string() + "/"}));
  EXPECT_EQ(first, "use-with-care");
  EXPECT_EQ(second, first);
}

TEST(VerdictFirst, AFileThatItsOwnProgramRefusesIsNotWrittenAgain) {
  const std::string chain = testdata("formats/kalibr/good/opencv-header.yaml");
  const Told run({"convert", chain, "--to", "kalibr"});
  EXPECT_EQ(run.code(), 1) << run.text();
  ASSERT_FALSE(run.json()["verdict"]["reasons"].Empty());
  const auto& reason = run.json()["verdict"]["reasons"][0];
  EXPECT_STREQ(reason["code"].GetString(), "program-refuses");
  EXPECT_GT(reason["fix"].GetStringLength(), 0U) << run.text();
  EXPECT_EQ(run_program({"convert", chain, "--to", "kalibr", "--rewrite"}).code, 0);
  EXPECT_EQ(run_program({"convert", chain, "--to", "kalibr", "--anew"}).code, 0) << "the older name";
}

TEST(VerdictFirst, OnStandardOutputNothingComesOfARefusedFile) {
  const RunResult run = run_program({"convert", kTumvi, "--to", "orbslam3", "--max-error", "1e-9", "--model", "radtan"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out, "");
}

TEST(VerdictFirst, StrictFailsForWhatMatters) {
  EXPECT_EQ(run_program({"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "--strict"}).code, 0) << "topics and overlaps";
  const TemporaryFolder folder;
  const std::string model = "  distortion_model: equidistant\n";
  const std::string delayed =
      folder.write("delayed.yaml", with_replaced(read_file(kTumvi), model, model + "  timeshift_cam_imu: 0.01\n"));
  EXPECT_EQ(run_program({"convert", delayed, "--with", kImu, "--to", "orbslam3", "--strict"}).code, 1);
}

TEST(VerdictFirst, AcceptKnowsItsCodes) {
  EXPECT_EQ(run_program({"convert", kTumvi, "--to", "opencv", "--accept", "no-such-code"}).code, 3);
  const RunResult unneeded = run_program({"convert", kTumvi, "--to", "opencv", "--accept", "left-handed"});
  EXPECT_EQ(unneeded.code, 0);
  EXPECT_TRUE(contains(unneeded.err, "--accept left-handed")) << unneeded.err;
}

TEST(VerdictFirst, DryRunsAndConversionsSayTheSame) {
  for (const char* model : {"kb4", "pinhole"}) {
    const std::vector<std::string> words = {"convert", kTumvi, "--to", "opencv", "--model", model};
    std::vector<std::string> dry = words;
    dry.emplace_back("--dry-run");
    const Told run(words);
    const Told tried(dry);
    EXPECT_EQ(run.code(), tried.code());
    EXPECT_EQ(run.json()["verdict"], tried.json()["verdict"]);
  }
}

// The page says what convert says. The file itself is another program's: check says that it is not to be used as it stands.
TEST(VerdictFirst, EveryOutputSaysTheSame) {
  const Told converted({"convert", kTumvi, "--to", "orbslam3"});
  const Told checked({"check", kTumvi, "--for", "orbslam3"});
  EXPECT_EQ(checked.code(), 1);
  const auto& verdict = checked.json()["files"][0]["verdict"];
  EXPECT_STREQ(verdict["word"].GetString(), "do-not-use") << checked.text();
  EXPECT_STREQ(verdict["reasons"][0]["code"].GetString(), "program-other-format") << checked.text();
  const RunResult page = run_program({"report", kTumvi, "--to", "orbslam3"});
  EXPECT_TRUE(contains(page.out, ">Ready<")) << word_of(converted);
}

// A lens of 195 degrees for OpenCV, whose rays end at 90: text, JSON and page give one share.
TEST(VerdictFirst, EveryOutputGivesTheSameShare) {
  const std::string lens = corpus("ocamcalib/matsuren__ocamcalib_undistort__ocamcamera__calib_results_0.txt");
  if (lens.empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const std::vector<std::string> words = {lens, "--to", "opencv"};
  const Told converted({"convert", words[0], words[1], words[2]});
  double share = 0.0;
  for (const auto& reason : converted.json()["verdict"]["reasons"].GetArray()) {
    if (std::string(reason["code"].GetString()) == "no-right-rays") share = reason["share"].GetDouble();
  }
  ASSERT_GT(share, 0.01) << converted.text();
  std::array<char, 16> percent{};
  std::snprintf(percent.data(), percent.size(), "%.1f %%", 100.0 * share);
  const RunResult text = run_program({"convert", words[0], words[1], words[2]}, {.in_full = false});
  EXPECT_TRUE(contains(text.err, percent.data())) << percent.data() << "\n" << text.err;
  const RunResult page = run_program({"report", words[0], words[1], words[2]});
  EXPECT_TRUE(contains(page.out, percent.data())) << percent.data();
  // And one word, on the page's card, too.
  const std::string word = word_of(converted);
  const std::string in_words = word == "do-not-use" ? "do not use" : word == "ready" ? "ready" : "use with care";
  EXPECT_TRUE(contains(text.err.substr(0, text.err.find('\n')), in_words)) << text.err;
  const std::string capital = std::string(1, static_cast<char>(std::toupper(in_words.front()))) + in_words.substr(1);
  EXPECT_TRUE(contains(page.out, ">" + capital + "<")) << word;
}

/// What a program's own project ships for it.
struct Shipped {
  const char* folder;
  const char* begins;
  const char* program;
};

// Where such a file is not to be used, a reason names the program that gets it wrong.
TEST(VerdictFirst, OfFilesThatAProjectShipsTheProgramsFaultIsNamed) {
  if (corpus("orbslam3").empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  constexpr std::array kShipped = {Shipped{"orbslam3", "thien94__orb_slam3_ros__", "ORB-SLAM3"},
                                   Shipped{"kalibr", "rpng__open_vins__", "OpenVINS"},
                                   Shipped{"kalibr", "ethz-asl__kalibr__", "Kalibr"}};
  int files = 0;
  for (const Shipped& shipped : kShipped) {
    for (const auto& entry : fs::directory_iterator(corpus(shipped.folder))) {
      if (!entry.path().filename().string().starts_with(shipped.begins)) continue;
      const Told run({"check", entry.path().string()});
      ++files;
      const auto& verdict = run.json()["files"][0]["verdict"];
      if (verdict["word"].GetString() != std::string("do-not-use")) continue;
      EXPECT_TRUE(
          std::ranges::any_of(verdict["reasons"].GetArray(),
                              [&](const auto& reason) { return contains(reason["text"].GetString(), shipped.program); }))
          << entry.path() << "\n"
          << run.text();
    }
  }
  EXPECT_GE(files, 30);
}

// What is wrong with the file's meaning counts for show, too.
TEST(VerdictFirst, ShowAndCheckSayTheSame) {
  const TemporaryFolder folder;
  const std::string wrong = folder.write("wrong.yaml", with_replaced(read_file(kTumvi), "[512, 512]", "[200, 512]"));
  const RunResult show = run_program({"show", wrong, "--for", "kalibr"});
  EXPECT_TRUE(contains(show.out.substr(0, show.out.find('\n')), "do not use")) << show.out;
  const Told check({"check", wrong});
  EXPECT_EQ(check.code(), 1) << check.text();
}

// VINS' configuration names the files of its cameras: without them it is not to be used, whoever says it.
TEST(VerdictFirst, AMissingPartCountsForShowAndCheck) {
  const TemporaryFolder folder;
  const std::string config = folder.write("config.yaml", read_file(fs::path(FCA_EXAMPLES_DIR) / "vins_config.yaml"));
  const RunResult show = run_program({"show", config, "--for", "vins"});
  EXPECT_EQ(show.code, 0);
  EXPECT_TRUE(contains(show.out.substr(0, show.out.find('\n')), "do not use")) << show.out;
  const Told check({"check", config});
  EXPECT_STREQ(check.json()["files"][0]["verdict"]["word"].GetString(), "do-not-use") << check.text();
}

// V1.0 undistorts no RGB-D images; the layout before it is read rightly, which a fresh file has.
TEST(VerdictFirst, AFreshFileIsOfferedWhereTheTextIsNotToBeUsed) {
  const TemporaryFolder folder;
  const std::string settings = folder / "rgbd.yaml";
  const std::string camera = folder.write("camera.yaml",
                                          "cam0:\n  camera_model: pinhole\n  distortion_model: radtan\n"
                                          "  distortion_coeffs: [-0.28, 0.07, 0.0002, 0.00002]\n"
                                          "  intrinsics: [458.6, 457.3, 367.2, 248.4]\n"
                                          "  resolution: [752, 480]\n  rostopic: /cam0\n");
  ASSERT_EQ(run_program({"convert", camera, "--to", "orbslam3", "--sensor", "rgbd", "--baseline", "0.08", "--orbslam3-layout",
                         "v1", "--accept", "pixels-off", "-o", settings})
                .code,
            0);
  const Told kept({"convert", settings, "--to", "orbslam3"});
  EXPECT_EQ(kept.code(), 1) << kept.text();
  EXPECT_TRUE(contains(kept.text(), "--rewrite")) << kept.text();
  EXPECT_EQ(Told({"convert", settings, "--to", "orbslam3", "--rewrite"}).code(), 0);
}

TEST(VerdictFirst, QuietSaysWhyAFileIsNotWritten) {
  const TemporaryFolder folder;
  const RunResult run =
      run_program({"convert", testdata("checks/left-handed.yaml"), "--to", "kalibr", "-q", "-o", folder / "out.yaml"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(contains(run.err, "--accept left-handed")) << run.err;
}

// With more inputs than have reports of their own the table names the word.
TEST(VerdictFirst, ALargeBatchNamesEveryWord) {
  const TemporaryFolder folder;
  for (int i = 0; i < 9; ++i) folder.write("good" + std::to_string(i) + ".yaml", read_file(kTumvi));
  folder.write("mirrored.yaml", read_file(testdata("checks/left-handed.yaml")));
  const RunResult run = run_program({"convert", folder.path().string(), "--to", "kalibr", "-o", folder / "out/"});
  EXPECT_EQ(run.code, 1);
  for (const VerdictWord word : {VerdictWord::kDoNotUse, VerdictWord::kReady})
    EXPECT_TRUE(contains(run.out, std::string(cli::in_words(word)))) << run.out;
  // The last line counts them.
  const std::string last = run.out.substr(run.out.find_last_of('\n', run.out.size() - 2) + 1);
  EXPECT_TRUE(contains(last, "9 ready")) << last;
  EXPECT_TRUE(contains(last, "1 do not use")) << last;
}

TEST(VerdictFirst, QuietSaysNothingOfAGoodFile) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", kTumvi, "--to", "kalibr", "--model", "ds", "-q", "-o", folder / "out.yaml"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out + run.err, "");
}

// Basalt reads radtan's terms since 2022: whoever has an older one needs another model, and hears what it costs.
TEST(Verdict, AModelThatOlderVersionsDoNotReadAsksForCare) {
  const std::string chain = testdata("checks/clean.yaml");
  const Told run({"convert", chain, "--to", "basalt", "--json"});
  EXPECT_EQ(run.code(), 0) << run.text();
  const auto& reasons = run.json()["verdict"]["reasons"];
  const auto* const found =
      std::find_if(reasons.Begin(), reasons.End(), [](const auto& reason) { return reason["code"] == "needs-version"; });
  ASSERT_NE(found, reasons.End()) << run.text();
  const std::string fix = (*found)["fix"].GetString();
  EXPECT_TRUE(contains(fix, "--model ")) << fix;
  EXPECT_FALSE(contains(Told({"convert", chain, "--to", "basalt", "--model", "kb4", "--json"}).text(), "needs-version"));
}

// 400 rays of a pinhole, one of which is 5 px off: the rms hides it.
TEST(Verdict, ARayThatIsFarFromAllOthersIsNamed) {
  const auto table = [](double shift) {
    std::string text = "u v x y z\n";
    for (int i = 0; i < 20; ++i) {
      for (int j = 0; j < 20; ++j) {
        const double x = 0.05 * (i - 9.5);
        const double y = 0.05 * (j - 9.5);
        const double u = 320.0 + 500.0 * x + (i == 12 && j == 7 ? shift : 0.0);
        text += std::to_string(u) + " " + std::to_string(240.0 + 500.0 * y) + " " + std::to_string(x) + " " +
                std::to_string(y) + " 1\n";
      }
    }
    return text;
  };
  const TemporaryFolder folder;
  const auto convert = [&folder](const std::string& rays) {
    std::ofstream(folder / "rays.txt") << rays;
    return Told({"convert", folder / "rays.txt", "--size", "640x480", "--to", "opencv", "--model", "pinhole"});
  };
  const Told good = convert(table(0.0));
  EXPECT_EQ(word_of(good), "ready") << good.text();
  const Told bad = convert(table(5.0));
  EXPECT_EQ(word_of(bad), "use-with-care") << bad.text();
  EXPECT_EQ(codes_of(bad), std::set<std::string>{"lens-in-doubt"}) << bad.text();
}

}  // namespace
}  // namespace fca::test
