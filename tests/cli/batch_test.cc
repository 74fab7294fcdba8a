// SPDX-License-Identifier: BSD-3-Clause
// convert with many inputs: folders, patterns, what is skipped, one table, one exit code, and nothing different from one by
// one.
#include "cli/run_program.h"
#include "cli/told.h"

#include <algorithm>
#include <iterator>
#include <sstream>

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

// What a pattern fits besides the cameras is no error, as in a folder; a file that is met twice is converted once.
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

/// A document but for how long its fits took and what made it.
rapidjson::Document timeless(const std::string& text) {
  const auto forget = [](const auto& self, rapidjson::Value& value, rapidjson::Document::AllocatorType& memory) -> void {
    if (value.IsObject()) {
      value.RemoveMember("time_us");
      for (auto& member : value.GetObject()) self(self, member.value, memory);
    } else if (value.IsArray()) {
      for (rapidjson::Value& each : value.GetArray()) self(self, each, memory);
    }
  };
  rapidjson::Document document;
  document.Parse(text.c_str());
  EXPECT_FALSE(document.HasParseError()) << text;
  forget(forget, document, document.GetAllocator());
  return document;
}

/// Good ones, a wrong one in the middle, and one without a camera; more than have their reports.
std::vector<std::string> fill_with_a_wrong_one(const TemporaryFolder& folder) {
  fs::create_directories(folder.path() / "rigs");
  std::vector<std::string> inputs;
  constexpr int kInputs = 12;
  for (int i = 0; i < kInputs; ++i) {
    const std::string chain = i == 5 ? with_replaced(kChain, "intrinsics: [", "intrinsics: [x") : kChain;
    inputs.push_back(folder.write("rigs/" + std::to_string(10 + i) + ".yaml", chain));
  }
  folder.write("rigs/package.json", "{}\n");
  return inputs;
}

// In the order of the inputs, with files and without, whether --json is given as well or not.
TEST(BatchLines, EachIsWhatJsonPrintsForThatInputAlone) {
  const TemporaryFolder folder;
  const std::vector<std::string> inputs = fill_with_a_wrong_one(folder);
  const std::vector<std::vector<std::string>> ways = {{"--json-lines"},
                                                      {"--json-lines", "--json"},
                                                      {"--json-lines", "-o", (folder / "out") + "/"},
                                                      {"--json-lines", "--dry-run", "-o", (folder / "new") + "/"}};
  for (const std::vector<std::string>& way : ways) {
    std::vector<std::string> command = {"convert", folder / "rigs", "--to", "orbslam3", "--model", "eucm", "--jobs", "3"};
    command.insert(command.end(), way.begin(), way.end());
    const RunResult run = run_program(command, {.in_full = false});
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_EQ(numbers_of_last_line(run.err).front(), 11) << run.err;
    const std::vector<std::string> lines = lines_of(run.out);
    ASSERT_EQ(lines.size(), inputs.size()) << run.out;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      std::vector<std::string> alone = {"convert", inputs[i], "--to", "orbslam3", "--model", "eucm", "--json"};
      for (const std::string& word : way) {
        if (word != "--json-lines" && word != "--json") alone.push_back(word);
      }
      fs::remove_all(folder.path() / "out");
      EXPECT_EQ(timeless(lines[i]), timeless(run_program(alone).out)) << lines[i];
    }
  }
}

TEST(BatchLines, OneInputIsOneLine) {
  const RunResult line = run_program({"convert", kDs, "--to", "basalt", "--json-lines"}, {.in_full = false});
  EXPECT_EQ(lines_of(line.out).size(), 1U) << line.out;
  EXPECT_EQ(line.err, "");
  EXPECT_EQ(timeless(line.out), timeless(run_program({"convert", kDs, "--to", "basalt", "--json"}).out));
}

// What ends the command before any input is told, and words that no command takes.
TEST(BatchLines, ARefusalIsALine) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "rigs");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"convert", folder / "rigs", "--to", "basalt", "--json-lines"},
        {"convert", kDs, "--to", "nothing", "--json-lines"},
        {"convert", kDs, "--no-such-option", "--json-lines"}}) {
    const RunResult run = run_program(command, {.in_full = false});
    ASSERT_EQ(lines_of(run.out).size(), 1U) << run.out;
    EXPECT_EQ(timeless(run.out)["exit_code"].GetInt(), run.code) << run.out;
  }
}

// The document of a file that was not written says so, and is otherwise that of the file that was.
TEST(Batch, WhatCannotBeWrittenIsInTheDocument) {
  const TemporaryFolder folder;
  fill(folder);
  for (const std::string& input : {folder / "rigs", kTumvi}) {
    const std::string out = (folder / "out") + "/";
    const std::vector<std::string> command = {"convert", input, "--to", "orbslam3", "--model", "eucm", "-o", out, "--json"};
    rapidjson::Document written = timeless(run_program(command).out);
    const RunResult run = run_program(command);
    EXPECT_EQ(run.code, 4) << run.err;
    rapidjson::Document refused = timeless(run.out);
    const auto member = [](rapidjson::Document& document) -> rapidjson::Value& {
      return document.HasMember("conversions") ? document["conversions"][0] : static_cast<rapidjson::Value&>(document);
    };
    EXPECT_EQ(member(refused)["exit_code"].GetInt(), 4);
    EXPECT_EQ(member(refused)["outputs"].Size(), 0U);
    const rapidjson::Value& said = member(refused)["diagnostics"];
    ASSERT_GT(said.Size(), 0U);
    EXPECT_STREQ(said[said.Size() - 1]["code"].GetString(), "cannot-write");
    for (const char* name : {"exit_code", "outputs", "diagnostics"}) {
      member(written).RemoveMember(name);
      member(refused).RemoveMember(name);
    }
    EXPECT_EQ(member(written), member(refused));
    fs::remove_all(folder.path() / "out");
  }
}

// Nothing of it is seen while it is at work or when it is done, also where there is no place for its file.
TEST(Batch, OfMoreThanFitsIntoMemoryNothingElseIsLeft) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "rigs");
  constexpr int kInputs = 60;  // of 4,000 bytes
  for (int i = 0; i < kInputs; ++i) folder.write("rigs/" + std::to_string(i) + ".yaml", kChain);
  const std::vector<std::string> command = {"convert", folder / "rigs", "--to", "orbslam3", "--no-provenance"};
  const auto with_output = [&command](const std::string& output) {
    std::vector<std::string> words = command;
    words.insert(words.end(), {"-o", output});
    return run_program(words);
  };
  EXPECT_EQ(with_output(folder / "out/deep/{stem}.yaml").code, 0);
  EXPECT_EQ(folder.names(), (std::set<std::string>{"out", "rigs"}));
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder.path() / "out"), fs::recursive_directory_iterator{}),
            kInputs + 1);
  const std::string alone = folder / "alone.yaml";
  EXPECT_EQ(run_program({"convert", folder / "rigs/7.yaml", "--to", "orbslam3", "--no-provenance", "-o", alone}).code, 0);
  for (int i = 0; i < kInputs; ++i)
    EXPECT_EQ(read_file(folder / ("out/deep/" + std::to_string(i) + ".yaml")), read_file(alone)) << i;
  const RunResult nowhere = with_output("/proc/out/");
  EXPECT_EQ(nowhere.code, 4);
  EXPECT_EQ(numbers_of_last_line(nowhere.out), (std::vector{0, kInputs, 0})) << nowhere.out;
}

// Far apart, among many, in a spool.
TEST(Batch, ACollisionAmongManyNamesBoth) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "rigs/z");
  constexpr int kInputs = 60;
  for (int i = 0; i < kInputs; ++i) folder.write("rigs/" + std::to_string(i) + ".yaml", kChain);
  folder.write("rigs/z/0.yaml", kChain);
  folder.write("rigs/z/1.yaml", kChain);
  const RunResult run = run_program({"convert", folder / "rigs", "--to", "orbslam3", "-o", (folder / "out") + "/"});
  EXPECT_EQ(run.code, 3);
  EXPECT_TRUE(contains(run.err, folder / "rigs/0.yaml") && contains(run.err, folder / "rigs/z/0.yaml")) << run.err;
  EXPECT_EQ(folder.names(), std::set<std::string>{"rigs"});
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
