// SPDX-License-Identifier: BSD-3-Clause
// Options do what they say or are refused; none is read halfway or without effect.
#include "cli/run_program.h"
#include "cli/told.h"

#include <rapidjson/document.h>

namespace fca::test {
namespace {

void expect_usage(const std::vector<std::string>& words, const std::string& word) {
  const RunResult run = run_program(words);
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_TRUE(contains(run.err, word)) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(Options, EmptyValuesAreRefused) {
  for (const char* option :
       {"--max-error", "--model", "--objective", "--sensor", "--fps", "--max-angle", "--size", "--with", "-o", "--baseline"})
    expect_usage({"convert", kTumvi, "--to", "orbslam3", option, ""}, option);
}

TEST(Options, FlagsHaveNoValues) {
  for (const char* flag :
       {"--provenance=none", "--no-provenance=1", "--progress=maybe", "--no-verify=x", "--strict=maybe", "-v=2"})
    EXPECT_EQ(run_program({"convert", kTumvi, "--to", "opencv", flag}).code, 3) << flag;
}

TEST(Options, AnObjectiveIsRmsOrMax) {
  for (const char* value : {"min", "MAX", "rms,max"})
    expect_usage({"convert", kTumvi, "--to", "orbslam3", "--objective", value}, value);
}

TEST(Options, NumbersAreDecimal) {
  for (const char* value : {"0x61", "97,5", "97.5deg", "1e", "--"})
    expect_usage({"convert", kTumvi, "--to", "orbslam3", std::string("--max-angle=") + value}, "--max-angle");
}

TEST(Options, UnknownPlaceholdersAreRefused) {
  expect_usage({"convert", kTumvi, "--to", "orbslam3", "-o", "{name}.yaml"}, "{stem}");
}

TEST(Options, AUsageErrorUnderJsonIsADocument) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"convert", kTumvi, "--to", "nothing", "--json"},
                                                {"convert", "--json"},
                                                {"convert", "--no-verify=1", "--json"},
                                                {"convert", "--no-such-option", "--json"},
                                                {"--json"},
                                                {"shwo", "--json"}}) {
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 3);
    rapidjson::Document document;
    document.Parse(run.out.c_str());
    ASSERT_FALSE(document.HasParseError()) << run.out;
    EXPECT_EQ(document["exit_code"].GetInt(), 3);
    EXPECT_EQ(document["diagnostics"].Size(), 1U);
  }
}

// A file, a value of another option, and a flag that is not set.
TEST(Options, AWordThatIsNoFlagPromisesNoDocument) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"show", "--", "--json"},
                                                {"show", "--from", "--json"},
                                                {"show", "--json=false", "no-such-file.yaml"},
                                                {"shwo", "--", "--json"}}) {
    const RunResult run = run_program(words);
    EXPECT_NE(run.code, 0);
    EXPECT_EQ(run.out, "");
  }
}

TEST(Options, ASizeThatContradictsTheFileIsRefused) {
  const RunResult run = run_program({"show", kTumvi, "--size", "640x480"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(says(run.err, "size-contradicts", "512 x 512")) << run.err;
  EXPECT_EQ(run_program({"show", kTumvi, "--size", "512x512"}).code, 0);
}

TEST(Options, TheBaselineOfTwoCamerasIsTheirPose) {
  const RunResult run = run_program({"convert", kTumvi, "--to", "orbslam3", "--baseline", "0.1"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(Options, NoneIsIgnored) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--fps", "30"}, {"--baseline", "0.1"}, {"--sensor", "mono"}, {"--orbslam3-layout", "old"}}) {
    std::vector<std::string> all = {"convert", kTumvi, "--camera", "cam0"};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<std::string> into = all;
    all.insert(all.end(), {"--to", "kalibr"});
    into.insert(into.end(), {"--into", kTumvi});
    expect_usage(all, words.front());
    expect_usage(into, words.front());
  }
  expect_usage({"convert", kTumvi, "--to", "orbslam3", "--opencv-layout", "stereo"}, "--opencv-layout");
  expect_usage({"convert", kTumvi, "--to", "kalibr", "--opencv-model", "fisheye"}, "--opencv-model");
}

TEST(Options, InPlaceSaysTheCommandThatWorks) {
  for (const std::vector<std::string>& to : {std::vector<std::string>{}, {"--to", "kalibr"}}) {
    std::vector<std::string> words = {"convert", kTumvi, "--in-place", "--model", "ds"};
    words.insert(words.end(), to.begin(), to.end());
    expect_usage(words, "convert " + kTumvi + " --into " + kTumvi + " --in-place");
  }
}

TEST(Options, MaxAngleCutsTheLensInProjectToo) {
  // 45 and 80 degrees from the axis.
  const RunResult run = run_program({"project", kTumvi, "--camera", "cam0", "--max-angle", "60"}, {"1 0 1\n5.6713 0 1\n"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_FALSE(first_line(run.out).starts_with("nan")) << run.out;
  EXPECT_TRUE(contains(run.out, "\nnan nan")) << run.out;
}

TEST(Options, ALayoutThatItsProgramRefusesIsRewritten) {
  const std::string chain = testdata("formats/kalibr/good/opencv-header.yaml");  // OpenVINS' first line
  EXPECT_EQ(run_program({"convert", chain, "--to", "kalibr"}).code, 1) << "Kalibr refuses it";
  const RunResult same = run_program({"convert", chain, "--to", "kalibr", "--accept", "program-refuses"});
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_EQ(same.out, read_file(chain));
  const RunResult other = run_program({"convert", chain, "--to", "kalibr", "--model", "kb4"});
  EXPECT_EQ(other.code, 0) << other.err;
  EXPECT_TRUE(says(other.err, "layout-not-kept")) << other.err;
}

TEST(Options, APoorFitIsWarnedOf) {
  const RunResult poor = run_program({"convert", kTumvi, "--to", "kalibr", "--model", "fov"});
  EXPECT_TRUE(says(poor.err, "poor-fit")) << poor.err;
  const RunResult good = run_program({"convert", kTumvi, "--to", "kalibr", "--model", "eucm", "--max-angle", "97.5"});
  EXPECT_FALSE(says(good.err, "poor-fit")) << good.err;
}

// Cameras that no settings hold are listed as lost, not fitted.
TEST(Options, OnlyWrittenCamerasAreReported) {
  const Told run({"convert", kTumvi, "--to", "orbslam3", "--sensor", "mono"});
  EXPECT_EQ(run.json()["cameras"].Size(), 1U);
  EXPECT_TRUE(run.lost("camera-dropped", "cam1")) << run.text();
}

// An option that may come several times takes one value each time: what follows is the input.
TEST(Options, TheInputMayFollowAnOptionWithAValue) {
  const std::string chain = testdata("formats/kalibr/good/tumvi.yaml");
  const std::string imu = testdata("formats/kalibr/good/imu.yaml");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"convert", "--to", "orbslam3", "--with", imu, chain},
        {"convert", "--to", "orbslam3", "--set", "Camera.RGB=0", "--set", "Camera.fps=30", chain},
        {"check", "--ignore", "number-as-text", chain}}) {
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 0) << run.err;
  }
}

}  // namespace
}  // namespace fca::test
