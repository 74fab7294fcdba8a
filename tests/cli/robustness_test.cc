// SPDX-License-Identifier: BSD-3-Clause
// Nothing ever crashes: every subcommand over real files of every format and over seeded ruins of ours ends with a code of the
// contract, in time.
#include "cli/spawn_program.h"
#include "formats/corpus_folders.h"
#include "ruins.h"

#include <fca/formats/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <random>

namespace fca::test {
namespace {

constexpr double kLimitSeconds = 5.0;

/// Of the one model of 80 cameras (text and binary), each of which has its place in a report.
double limit_for(const std::string& path) {
  return path.find("5697526__NeRF-TensoRF__sparse__0__cameras.") == std::string::npos ? kLimitSeconds : 6.0 * kLimitSeconds;
}

const std::vector<std::vector<std::string>> kCommands = {{"show"},
                                                         {"show", "--json"},
                                                         {"convert", "--to", "orbslam3"},
                                                         {"convert", "--to", "kalibr"},
                                                         {"convert", "--to", "opencv"},
                                                         {"convert", "--to", "ocamcalib"},
                                                         {"convert", "--to", "woodscape"},
                                                         {"convert", "--to", "tumvi"},
                                                         {"convert", "--to", "orbslam3", "--model", "eucm", "--json"},
                                                         {"compare", testdata("formats/kalibr/good/tumvi.yaml")},
                                                         {"report", "--model", "eucm"},
                                                         {"remap", "--camera", "0", "--pinhole", "90", "--map", "map.npy"},
                                                         {"rectify", "--to", "opencv"},
                                                         {"rectify", "--maps", "-o", "maps/", "--json"},
                                                         {"project", "--camera", "0"},
                                                         {"unproject", "--camera", "0"}};

/// None where there is no such folder: a format may be told by its name alone.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Under sanitizers a process takes longer to start than most runs last, and what they find ends this one as well.
RunResult run_watched(const std::vector<std::string>& command, const RunOptions& options) {
  return is_sanitized() ? run_program(command, options) : spawn_program(command, options);
}

class Watch {
 public:
  /// False if the run broke the contract (and failed the test).
  bool run(std::vector<std::string> command, const std::string& path, const std::string& what) {
    command.insert(command.begin() + 1, path);
    const RunResult run = run_watched(command, {.input = "0.1 0.2 1\n", .limit_seconds = limit_for(path), .in_full = false});
    std::string spelled;
    for (const std::string& word : command) spelled += word + " ";
    const bool ended_well = !run.timed_out && run.signal == 0 && run.code >= 0 && run.code <= 4;
    EXPECT_FALSE(run.timed_out) << what << ": " << spelled << " takes more than " << limit_for(path) << " s";
    EXPECT_TRUE(run.timed_out || ended_well)
        << what << ": " << spelled << " ends with code " << run.code << ", signal " << run.signal << "\n"
        << run.err;
    EXPECT_TRUE(!ended_well || run.code == 0 || run.code == 1 || !run.err.empty() || contains(run.out, "\"severity\""))
        << what << ": " << spelled << " fails without a word";
    if (run.seconds > slowest_) {
      slowest_ = run.seconds;
      slowest_what_ = what + ": " + spelled;
    }
    ++codes_[run.code];
    ++runs_;
    return ended_well;
  }

  void print() const {
    for (const auto& [code, count] : codes_) std::printf("exit code %d: %d runs\n", code, count);
    std::printf("slowest: %.2f s, %s\n", slowest_, slowest_what_.c_str());
  }

  [[nodiscard]] int runs() const { return runs_; }

 private:
  std::map<int, int> codes_;
  double slowest_ = 0.0;
  std::string slowest_what_;
  int runs_ = 0;
};

// A test per format, so that they run next to each other.
class CorpusRobustness : public testing::TestWithParam<const Format*> {};

TEST_P(CorpusRobustness, EverySubcommandOverRealFiles) {
  std::vector<fs::path> files;
  for (const fs::path& folder : corpus_folders(FCA_SHARED_DIR, GetParam()->id))
    std::ranges::copy(files_in(folder), std::back_inserter(files));
  if (files.empty()) GTEST_SKIP() << "no corpus of it in '" FCA_SHARED_DIR "'";
  Watch watch;
  // One command in two, the others for the next file. Under sanitizers one in five: there the code that runs matters.
  const std::size_t step = is_sanitized() ? 5 : 2;
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (std::size_t j = i % step; j < kCommands.size(); j += step)
      watch.run(kCommands[j], files[i].string(), files[i].filename().string());
  }
  watch.print();
  EXPECT_GE(static_cast<std::size_t>(watch.runs()) * step, files.size() * (kCommands.size() - step));
}

std::vector<const Format*> formats() {
  std::vector<const Format*> result;
  for (const Format& format : all_formats()) result.push_back(&format);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Formats, CorpusRobustness, testing::ValuesIn(formats()),
                         [](const testing::TestParamInfo<const Format*>& format) {
                           std::string name(format.param->id);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(Robustness, SeededRuins) {
  std::vector<fs::path> sources;
  for (const Format& format : all_formats()) {
    std::ranges::copy(files_in(fs::path(FCA_TESTDATA_DIR) / "formats" / format.id / "good"), std::back_inserter(sources));
  }
  ASSERT_GE(sources.size(), 10U);
  std::mt19937 random(500);
  const TemporaryFolder folder;
  Watch watch;
  constexpr int kRuins = 500;
  for (int i = 0; i < kRuins; ++i) {
    const fs::path& source = sources[random() % sources.size()];
    std::string bytes = ruined(read_file(source), random);
    if (random() % 3 == 0) bytes = ruined(bytes, random);
    const std::string path = folder.write("ruin" + source.extension().string(), bytes);
    const bool good = watch.run(kCommands[static_cast<std::size_t>(i) % kCommands.size()], path, "ruin " + std::to_string(i));
    if (!good) std::printf("---- ruin %d\n%s\n----\n", i, bytes.c_str());
  }
  watch.print();
  EXPECT_EQ(watch.runs(), kRuins);
}

// What once crashed or hung, at its smallest; tests/fuzz replays the same files in memory.
TEST(Robustness, KnownCrashes) {
  const std::vector<fs::path> files = files_in(fs::path(FCA_TESTDATA_DIR) / "crashes");
  ASSERT_GE(files.size(), 5U);
  Watch watch;
  for (const fs::path& path : files) {
    for (const std::vector<std::string>& command : kCommands) watch.run(command, path.string(), path.filename().string());
  }
  EXPECT_EQ(static_cast<std::size_t>(watch.runs()), files.size() * kCommands.size());
}

// Just under the limit of size, with as many keys as fit: no step may be quadratic.
TEST(Robustness, ManyKeysAreReadInTime) {
  const TemporaryFolder folder;
  for (const char* head : {"cam0:\n  camera_model: pinhole\n", "%YAML:1.0\nCamera.fx: 1.0\n"}) {
    std::string bytes = head;
    for (int i = 0; bytes.size() < 1'900'000; ++i) bytes += "k" + std::to_string(i % 100'000) + ": 1\n";
    const RunResult run = spawn_program({"show", folder.write("keys.yaml", bytes)}, {.limit_seconds = 30.0});
    EXPECT_FALSE(run.timed_out);
    EXPECT_EQ(run.code, 2) << run.err.substr(0, 500);
  }
}

TEST(Robustness, OptionsAloneDoNotCrash) {
  for (const char* subcommand : {"convert", "show", "report", "remap", "rectify", "project", "unproject", "formats", "models",
                                 "programs", "--json", "-", "--", "", "."}) {
    const RunResult run = spawn_program({subcommand}, {.limit_seconds = kLimitSeconds});
    EXPECT_EQ(run.signal, 0) << subcommand;
    EXPECT_TRUE(run.code >= 0 && run.code <= 4) << subcommand << " " << run.code << run.err;
  }
}

}  // namespace
}  // namespace fca::test
