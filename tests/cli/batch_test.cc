// SPDX-License-Identifier: BSD-3-Clause
// convert with many inputs: folders, patterns, what is skipped, one table, one exit code, and nothing different from one by
// one.
#include "cli/run_program.h"
#include "cli/told.h"

#include <algorithm>
#include <iterator>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

const std::string kChain = read_file(testdata("formats/kalibr/good/tumvi.yaml"));

/// A folder of chains, with what else lies in such folders.
void fill(const TemporaryFolder& folder) {
  fs::create_directories(folder.path() / "rigs" / "inner");
  folder.write("rigs/a.yaml", kChain);
  folder.write("rigs/b.yaml", kChain);
  folder.write("rigs/inner/c.yaml", kChain);
  folder.write("rigs/imu.yaml", read_file(testdata("formats/kalibr/good/imu.yaml")));
  folder.write("rigs/package.json", "{\"name\": \"x\"}\n");
}

TEST(Batch, AFolderIsConvertedAndWhatHoldsNoCameraCounted) {
  const TemporaryFolder folder;
  fill(folder);
  const RunResult run =
      run_program({"convert", folder / "rigs", "--to", "orbslam3", "--max-angle", "97.5", "-o", (folder / "out") + "/"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(numbers_of_last_line(run.out), (std::vector{3, 3, 3, 2}))
      << "converted, files written, without a camera: " << run.out;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "out"), fs::directory_iterator{}), 3);
  EXPECT_EQ(run.err.find("imu.yaml"), std::string::npos) << "what was only met in a folder is no error: " << run.err;
}

// The command's own patterns, for where no shell expands them; and the bytes are those of one conversion alone, whatever
// --jobs.
TEST(Batch, APatternGivesTheBytesOfOneByOne) {
  const TemporaryFolder folder;
  fill(folder);
  const std::vector<std::string> options = {"--to", "orbslam3", "--max-angle", "97.5", "--no-provenance"};
  const auto with = [&options](std::vector<std::string> words) {
    words.insert(words.end(), options.begin(), options.end());
    return words;
  };
  for (const char* jobs : {"1", "2", "7"}) {
    const std::string out = folder / (std::string("out") + jobs);
    const RunResult run = run_program(with({"convert", folder / "rigs/[ab].yaml", "--jobs", jobs, "-o", out + "/{stem}.yaml"}));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(numbers_of_last_line(run.out), (std::vector{2, 2, 2})) << run.out;
    for (const char* name : {"a", "b"}) {
      const std::string alone = folder / "alone.yaml";
      EXPECT_EQ(run_program(with({"convert", folder / ("rigs/" + std::string(name) + ".yaml"), "-o", alone, "--force"})).code,
                0);
      EXPECT_EQ(read_file(out + "/" + name + ".yaml"), read_file(alone)) << name;
    }
  }
  const RunResult none = run_program(with({"convert", folder / "rigs/z*.yaml", "-o", (folder / "out") + "/"}));
  EXPECT_EQ(none.code, 4);
  EXPECT_TRUE(contains(none.err, "z*.yaml")) << none.err;
}

// What a pattern fits beside the cameras is no error, as in a folder; a file that is met twice is converted once.
TEST(Batch, WhatAPatternFitsBesideTheCamerasIsCounted) {
  const TemporaryFolder folder;
  fill(folder);
  const RunResult run = run_program({"convert", folder / "rigs/*", folder / "rigs/a.yaml", folder / "rigs/../rigs", "--to",
                                     "basalt", "-o", (folder / "out") + "/"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(numbers_of_last_line(run.out), (std::vector{3, 3, 3, 2}))
      << "converted, files written, without a camera: " << run.out;
}

TEST(Batch, TheWorstExitCodeIsReturnedAndTheOthersAreWritten) {
  const TemporaryFolder folder;
  fill(folder);
  const std::string broken = folder.write("broken.yaml", with_replaced(kChain, "intrinsics: [", "intrinsics: [x"));
  const RunResult run = run_program(
      {"convert", folder / "rigs/a.yaml", broken, folder / "rigs/b.yaml", "--to", "basalt", "-o", (folder / "out") + "/"});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(numbers_of_last_line(run.out), (std::vector{2, 3, 2})) << run.out;
  EXPECT_TRUE(contains(run.out, "not-a-number\n")) << run.out;
  EXPECT_TRUE(says(run.err, "not-a-number", broken + ":")) << run.err;
}

// Two inputs of one name: refused before a single file is written, both are named, and the pattern that is advised parts them.
TEST(Batch, CollisionsAreRefusedBeforeAnythingIsWritten) {
  for (const std::string twin : {"rigs/inner/a.yaml", "rigs/a.yml"}) {
    const TemporaryFolder folder;
    fill(folder);
    folder.write(twin, kChain);
    const RunResult run = run_program({"convert", folder / "rigs", "--to", "basalt", "-o", (folder / "out") + "/"});
    EXPECT_EQ(run.code, 3);
    for (const std::string& named : {folder / "rigs/a.yaml", folder / twin, (folder / "out") + "/a.basalt.json"})
      EXPECT_TRUE(contains(run.err, named)) << run.err;
    EXPECT_FALSE(fs::exists(folder.path() / "out"));
    const std::size_t from = run.err.find("'out/") + std::string_view("'out/").size();
    ASSERT_LT(from, run.err.size()) << run.err;
    const std::string pattern = run.err.substr(from, run.err.find('\'', from) - from);
    const RunResult again = run_program({"convert", folder / "rigs", "--to", "basalt", "-o", folder / ("out/" + pattern)});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(numbers_of_last_line(again.out), (std::vector{4, 4, 4, 2})) << again.out;
  }
}

// Forced to disk all at once, and still each for itself: one that cannot be written takes no other along.
TEST(Batch, WithFsyncTheOthersAreWritten) {
  const TemporaryFolder folder;
  fill(folder);
  const std::string out = folder / "out";
  const std::vector<std::string> command = {"convert", folder / "rigs", "--to", "basalt", "-o", out + "/", "--no-provenance"};
  EXPECT_EQ(run_program(command).code, 0);
  const std::string plain = read_file(out + "/b.basalt.json");
  fs::remove(out + "/b.basalt.json");
  fs::remove(out + "/c.basalt.json");
  std::vector<std::string> forced = command;
  forced.emplace_back("--fsync");
  const RunResult run = run_program(forced);
  EXPECT_EQ(run.code, 4);
  EXPECT_TRUE(says(run.err, "cannot-write", out + "/a.basalt.json")) << run.err;
  EXPECT_EQ(numbers_of_last_line(run.out), (std::vector{2, 3, 2, 2})) << run.out;
  EXPECT_EQ(read_file(out + "/b.basalt.json"), plain);
  EXPECT_TRUE(fs::exists(out + "/c.basalt.json"));
}

TEST(Batch, ManyInputsAreATableAndOneDocument) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "rigs");
  constexpr int kInputs = 12;
  for (int i = 0; i < kInputs; ++i) folder.write("rigs/" + std::to_string(i) + ".yaml", kChain);
  const RunResult run = run_program({"convert", folder / "rigs", "--to", "basalt", "-o", (folder / "out") + "/"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(std::ranges::count(run.out, '\n'), kInputs + 4) << "a line each, a title, and the summary: " << run.out;
  EXPECT_EQ(run.err.find('\r'), std::string::npos) << "no progress bar in a pipe";
  const RunResult json = run_program({"convert", folder / "rigs", "--to", "basalt", "-o", (folder / "again") + "/", "--json"});
  rapidjson::Document document;
  document.Parse(json.out.c_str());
  ASSERT_FALSE(document.HasParseError()) << json.out;
  EXPECT_EQ(document["conversions"].Size(), static_cast<unsigned>(kInputs));
}

TEST(Batch, AFolderWithoutACalibrationIsAnError) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "rigs");
  folder.write("rigs/package.json", "{\"name\": \"x\"}\n");
  const RunResult run = run_program({"convert", folder / "rigs", "--to", "basalt", "-o", (folder / "out") + "/"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, folder / "rigs")) << run.err;
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

}  // namespace
}  // namespace fca::test
