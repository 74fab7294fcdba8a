// SPDX-License-Identifier: BSD-3-Clause
// Runs the program as a user does, in a folder of its own, and says what came of it.
#pragma once

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

extern char** environ;

namespace fca::test {

namespace fs = std::filesystem;

/// A folder that is gone when the test is.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "fca-io-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::permissions(path_, fs::perms::owner_all, ignored);
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }
  /// The path of a name in the folder.
  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  /// Writes a file into the folder and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const {
    const std::string path = *this / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  /// Names of everything in the folder, hidden files included.
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> result;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) result.insert(entry.path().filename().string());
    return result;
  }

 private:
  fs::path path_;
};

inline std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// How a run ended.
struct RunResult {
  int code = -1;  ///< The exit code; -1 if a signal ended it.
  int signal = 0;
  bool timed_out = false;
  double seconds = 0.0;
  std::string out;
  std::string err;
};

// The sanitizers' checks make the program this much slower (20 to 35 times in a fit); limits of time are for the program as
// users run it.
#ifdef __SANITIZE_ADDRESS__
inline constexpr double kSlowdown = 20.0;
#else
inline constexpr double kSlowdown = 1.0;
#endif

struct RunOptions {
  std::string input;            ///< Standard input.
  std::string output_path;      ///< Where standard output goes instead of into RunResult::out ("/dev/full").
  std::string folder;           ///< Working directory; empty: a fresh one.
  double limit_seconds = 60.0;  ///< Of the release build.
};

/// Runs `words` (the program's path in front is added).
inline RunResult run_program(const std::vector<std::string>& words, const RunOptions& options = {}) {
  const TemporaryFolder files;
  const std::string in = files.write("in", options.input);
  const std::string out = options.output_path.empty() ? files / "out" : options.output_path;
  const std::string err = files / "err";
  const std::string folder = options.folder.empty() ? files.path().string() : options.folder;

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, in.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());

  std::vector<std::string> all = {FCA_IO};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> argv;
  for (std::string& word : all) argv.push_back(word.data());
  argv.push_back(nullptr);

  RunResult run;
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&start] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  pid_t child = 0;
  const int spawned = posix_spawn(&child, FCA_IO, &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  EXPECT_EQ(spawned, 0) << FCA_IO;
  if (spawned != 0) return run;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (elapsed() > options.limit_seconds * kSlowdown) {
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
  if (options.output_path.empty()) run.out = read_file(out);
  run.err = read_file(err);
  return run;
}

inline std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// `text` with one occurrence of `from`, which must be there, replaced by `to`.
inline std::string with_replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// A file of testdata.
inline std::string testdata(const std::string& name) { return std::string(FCA_TESTDATA_DIR) + "/" + name; }

}  // namespace fca::test
