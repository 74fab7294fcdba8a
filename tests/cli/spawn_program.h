// SPDX-License-Identifier: BSD-3-Clause
// Runs the executable: for tests of what is the process's (exit codes, streams, signals, limits), not of what a command does.
#pragma once

#include "cli/run_program.h"

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace fca::test {

/// That of the build whose tests run, also where their objects are another's.
inline std::string executable() {
  const char* path = std::getenv("FCA_IO");
  return path != nullptr ? path : FCA_IO;
}

/// Runs the executable with these words. `output_path`: where standard output goes instead of into RunResult::out
/// ("/dev/full").
inline RunResult spawn_program(const std::vector<std::string>& words, const RunOptions& options = {},
                               const std::string& output_path = {}) {
  const TemporaryFolder files;
  const std::string in = files.write("in", options.input);
  const std::string out = output_path.empty() ? files / "out" : output_path;
  const std::string err = files / "err";
  const std::string folder = options.folder.empty() ? files.path().string() : options.folder;

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, in.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());

  std::vector<std::string> all = {executable()};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> argv;
  for (std::string& word : all) argv.push_back(word.data());
  argv.push_back(nullptr);

  RunResult run;
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&start] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  pid_t child = 0;
  const int spawned = posix_spawn(&child, all.front().c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  EXPECT_EQ(spawned, 0) << all.front();
  if (spawned != 0) return run;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (elapsed() > options.limit_seconds * slowdown()) {
      run.timed_out = true;
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  run.seconds = elapsed();
  if (WIFEXITED(status)) run.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  if (output_path.empty()) run.out = read_file(out);
  run.err = read_file(err);
  return run;
}

}  // namespace fca::test
