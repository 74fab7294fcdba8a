// SPDX-License-Identifier: BSD-3-Clause
// Runs the command as a user does, in a folder of its own, and says what came of it. In the test's own process, which takes
// milliseconds; what the process itself has to do with (signals, limits, streams that fail) is for spawn_program.h.
#pragma once

#include "command.h"
#include "sanitized.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

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

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

inline std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// How a run ended.
struct RunResult {
  int code = -1;  ///< The exit code; -1 if a signal ended it.
  int signal = 0;
  bool timed_out = false;  ///< And was killed, if it was spawned.
  double seconds = 0.0;
  std::string out;
  std::string err;
};

/// The sanitizers' checks make the program this much slower (20 to 35 times in a fit); limits of time are for the program as
/// users run it.
inline double slowdown() { return is_sanitized() ? 20.0 : 1.0; }

struct RunOptions {
  std::string input;            ///< Standard input.
  std::string folder;           ///< Working directory; empty: a fresh one.
  double limit_seconds = 60.0;  ///< Of the release build.
  bool in_full = true;          ///< `convert` prints all that it found (-v), not the summary alone.
};

/// What is written is kept.
class MemoryOutput : public cli::Output {
 public:
  explicit MemoryOutput(std::string& text) : text_(text) {}

  void write(std::string_view bytes) override { text_ += bytes; }
  std::optional<std::string> flush() override { return std::nullopt; }
  [[nodiscard]] bool failed() const override { return false; }
  [[nodiscard]] bool is_terminal() const override { return false; }

 private:
  std::string& text_;
};

/// While it lives, the process works in that folder.
class WorkingFolder {
 public:
  explicit WorkingFolder(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
  ~WorkingFolder() {
    std::error_code ignored;
    fs::current_path(before_, ignored);
  }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  fs::path before_;
};

/// Runs the command in this process.
inline RunResult run_program(std::vector<std::string> words, const RunOptions& options = {}) {
  const auto has = [&words](const char* word) { return std::ranges::find(words, word) != words.end(); };
  if (options.in_full && !words.empty() && words.front() == "convert" && !has("--json") && !has("-q")) words.emplace_back("-v");
  const TemporaryFolder fresh;
  const WorkingFolder folder(options.folder.empty() ? fresh.path() : fs::path(options.folder));
  RunResult run;
  std::istringstream in(options.input);
  MemoryOutput out(run.out);
  MemoryOutput err(run.err);
  cli::Streams streams = {in, out, err};
  const auto start = std::chrono::steady_clock::now();
  run.code = cli::run(words, streams);
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.timed_out = run.seconds > options.limit_seconds * slowdown();
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

/// Calibrations of Kalibr's that most tests convert: TUM-VI's pair of fisheyes and its IMU, and a camera of the models ds,
/// eucm.
inline const std::string kTumvi = testdata("formats/kalibr/good/tumvi.yaml");
inline const std::string kImu = testdata("formats/kalibr/good/imu.yaml");
inline const std::string kDs = testdata("formats/kalibr/good/ds.yaml");
inline const std::string kEucm = testdata("formats/kalibr/good/eucm.yaml");

}  // namespace fca::test
