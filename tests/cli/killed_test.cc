// SPDX-License-Identifier: BSD-3-Clause
// A command that is killed at any moment, and several that write the same file: the old bytes or the new, never half of them.
#include "cli/spawn_program.h"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <random>
#include <thread>

#include <sys/file.h>

namespace fca::test {
namespace {

std::vector<std::string> conversion_to(const std::string& output) {
  return {"convert", kTumvi, "--to", "orbslam3", "--max-angle", "97.5", "-o", output, "--force"};
}

/// Names in the folder that a killed command left.
std::size_t leftovers(const TemporaryFolder& folder) {
  std::size_t count = 0;
  for (const std::string& name : folder.names()) count += name.starts_with(".fca-io-") ? 1 : 0;
  return count;
}

TEST(Killed, WhileItWritesTheFileIsTheOldOrTheNew) {
  const TemporaryFolder folder;
  const std::string output = folder.write("settings.yaml", "");
  const RunResult whole = spawn_program(conversion_to(output));
  ASSERT_EQ(whole.code, 0) << whole.err;
  const std::string written = read_file(output);
  const std::string old = "%YAML:1.0\n# the old one\n";

  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> moment(0.0, 1.1 * whole.seconds / slowdown());
  int finished = 0;
  const int runs = is_sanitized() ? 30 : 300;  // sanitizers look at what a run does, not at when it ends
  for (int i = 0; i < runs; ++i) {
    folder.write("settings.yaml", old);
    const RunResult run = spawn_program(conversion_to(output), {.limit_seconds = moment(random)});
    const std::string bytes = read_file(output);
    ASSERT_TRUE(bytes == old || bytes == written) << "after " << run.seconds << " s: " << bytes.size() << " bytes";
    finished += bytes == written ? 1 : 0;
  }
  std::printf("%d of %d runs had put the new file in place; %zu temporary files left\n", finished, runs, leftovers(folder));
  EXPECT_LT(finished, runs);
  EXPECT_EQ(spawn_program(conversion_to(output)).code, 0);
  EXPECT_EQ(leftovers(folder), 0U);
}

TEST(Killed, WhatIsLeftOfAnotherIsRemovedAndWhatIsInUseStays) {
  const TemporaryFolder folder;
  folder.write(".fca-io-0123456789abcdef", "half a fi");
  const std::string in_use = folder.write(".fca-io-fedcba9876543210", "of a command that still writes");
  const int file = ::open(in_use.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(::flock(file, LOCK_EX), 0);
  EXPECT_EQ(spawn_program(conversion_to(folder / "settings.yaml")).code, 0);
  ::close(file);
  EXPECT_EQ(folder.names(), (std::set<std::string>{".fca-io-fedcba9876543210", "settings.yaml"}));
}

// A batch that is asked to end finishes what it has begun to write, and leaves nothing else.
TEST(Killed, ABatchThatIsAskedToEndLeavesWholeFilesAlone) {
  const TemporaryFolder folder;
  constexpr int kInputs = 40;
  fs::create_directory(folder.path() / "in");
  for (int i = 0; i < kInputs; ++i) fs::copy_file(kTumvi, folder.path() / "in" / ("chain" + std::to_string(100 + i) + ".yaml"));
  const auto command = [&folder](const std::string& how, const std::string& output) {
    return how + " " + executable() + " convert " + folder / "in" + " --to orbslam3 --max-angle 97.5 --no-provenance -o " +
           folder / output + "/ >" + folder / "log" + " 2>&1";
  };
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(std::system(command("", "whole").c_str()), 0) << read_file(folder / "log");
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::map<std::string, std::string> whole;
  for (const fs::directory_entry& each : fs::directory_iterator(folder.path() / "whole"))
    whole[each.path().filename()] = read_file(each.path());
  ASSERT_EQ(whole.size(), static_cast<std::size_t>(kInputs));

  const int runs = is_sanitized() ? 2 : 8;
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    int told = 0;  // runs that ended by themselves, early, with their summary
    for (int i = 0; i < runs; ++i) {
      const std::string after = std::to_string(seconds * (i + 0.5) / runs);
      EXPECT_NE(std::system(command("timeout --signal=" + signal + " " + after, "cut").c_str()), -1);
      told += contains(read_file(folder / "log"), "interrupted: ") ? 1 : 0;
      if (!fs::exists(folder / "cut")) continue;  // it had not begun to write
      for (const fs::directory_entry& each : fs::directory_iterator(folder.path() / "cut"))
        EXPECT_EQ(read_file(each.path()), whole[each.path().filename()]) << each.path() << " after SIG" << signal;
      fs::remove_all(folder / "cut");
    }
    EXPECT_GT(told, 0) << "SIG" << signal;
  }
}

// Each file is one command's, whole: whoever reads meanwhile never sees another.
TEST(ConcurrentWriters, LeaveOneOfTheirFilesWhole) {
  const TemporaryFolder folder;
  const std::string output = folder.write("settings.yaml", "");
  std::set<std::string> possible;
  std::vector<std::vector<std::string>> commands;
  for (const char* features : {"900", "1500"}) {
    std::vector<std::string> command = conversion_to(output);
    command.insert(command.end(), {"--set", std::string("ORBextractor.nFeatures=") + features, "--no-provenance"});
    ASSERT_EQ(spawn_program(command).code, 0);
    possible.insert(read_file(output));
    commands.push_back(command);
  }
  ASSERT_EQ(possible.size(), commands.size());
  constexpr int kWriters = 4;
  constexpr int kTimes = 12;
  std::atomic<int> failed = 0;
  std::atomic<int> at_work = kWriters;
  std::vector<std::thread> writers;
  for (int i = 0; i < kWriters; ++i) {
    writers.emplace_back([&, i] {
      for (int time = 0; time < kTimes; ++time)
        failed += spawn_program(commands[static_cast<std::size_t>((i + time) % 2)]).code == 0 ? 0 : 1;
      --at_work;
    });
  }
  int looks = 0;
  int torn = 0;
  for (; at_work > 0; ++looks) torn += possible.contains(read_file(output)) ? 0 : 1;
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(torn, 0) << "of " << looks << " looks";
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(folder.names(), std::set<std::string>{"settings.yaml"});
}

}  // namespace
}  // namespace fca::test
