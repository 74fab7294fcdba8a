// SPDX-License-Identifier: BSD-3-Clause
// Many files at once: bench-batch [FILES] makes that many (10,000) different chains of two Double Sphere cameras and converts
// them to ORB-SLAM3's kb4 and eucm with all processors, with the proof and without. Time, processor time and the largest memory
// of each; next to them an empty C++ program, which compares machines. bench-batch --memory FILES... does one conversion of
// each number of files, as text and as JSON, and says how much memory a file more takes.
#include "child.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using fca::bench::run;
using fca::bench::Run;

/// A camera as Kalibr writes it, a little different each time.
std::string camera(int index, std::mt19937& random) {
  const auto about = [&random](double value) {
    return std::to_string(value * std::uniform_real_distribution<double>(0.98, 1.02)(random));
  };
  const std::string pose = "  - [1.0, 0.0, 0.0, " + about(-0.11) +
                           "]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n";
  return "cam" + std::to_string(index) + ":\n" + (index > 0 ? "  T_cn_cnm1:\n" + pose : "") + "  cam_overlaps: [" +
         std::to_string(1 - index) +
         "]\n  camera_model: ds\n  distortion_coeffs: []\n  distortion_model: none\n  intrinsics: [" + about(-0.2443) + ", " +
         about(0.5657) + ", " + about(348.1) + ", " + about(347.1) + ", " + about(365.8) + ", " + about(249.4) +
         "]\n  resolution: [752, 480]\n  rostopic: /cam" + std::to_string(index) + "/image_raw\n";
}

void make_chains(const fs::path& folder, int count) {
  fs::create_directories(folder);
  std::mt19937 random(1);
  for (int i = 0; i < count; ++i)
    std::ofstream(folder / (std::to_string(i) + ".yaml")) << camera(0, random) << camera(1, random);
}

/// A folder of its own for each number of files.
void print_memory(const fs::path& folder, const std::vector<int>& counts) {
  for (const std::string how : {"", "--json", "--json-lines"}) {
    double first = 0.0;
    for (const int count : counts) {
      const fs::path in = folder / std::to_string(count);
      if (!fs::exists(in)) make_chains(in, count);
      const fs::path out = folder / "out/";
      std::vector<std::string> words = {FCA_IO,    "convert", in.string(), "--to",      "orbslam3",
                                        "--model", "eucm",    "-o",        out.string()};
      if (!how.empty()) words.push_back(how);
      const Run all = run(words);
      fs::remove_all(out);
      if (first == 0.0) first = all.megabytes;
      std::printf("%-12s %7d files  %7.1f s  processors %7.1f s  %6.1f MB", how.c_str(), count, all.seconds,
                  all.processor_seconds, all.megabytes);
      if (count > counts.front())
        std::printf("  %5.0f bytes a file", (all.megabytes - first) * 1048576.0 / (count - counts.front()));
      std::printf("  exit %d\n", all.code);
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  std::string pattern = (fs::temp_directory_path() / "fca-io-batch-XXXXXX").string();
  const fs::path folder = ::mkdtemp(pattern.data());
  if (count > 2 && std::string_view(arguments[1]) == "--memory") {
    std::vector<int> counts;
    for (int i = 2; i < count; ++i) counts.push_back(std::atoi(arguments[i]));
    print_memory(folder, counts);
    fs::remove_all(folder);
    return 0;
  }
  const int files = count > 1 ? std::atoi(arguments[1]) : 10000;
  make_chains(folder / "in", files);
  double empty = 1e9;
  for (int i = 0; i < 20; ++i) empty = std::min(empty, run({FCA_EMPTY_PROGRAM}).seconds);
  std::printf("%d chains of two cameras; an empty program takes %.2f ms\n", files, 1e3 * empty);
  int worst = 0;
  for (const std::string model : {"kb4", "eucm"}) {
    for (const bool proof : {true, false}) {
      // Into a folder of its own: a file system takes longer to replace files that it has just got.
      const std::string out = model + (proof ? "-proof" : "") + "/";
      std::vector<std::string> words = {FCA_IO, "convert", (folder / "in").string(), "--to", "orbslam3", "--model",
                                        model,  "-o",      (folder / out).string()};
      if (!proof) words.emplace_back("--no-verify");
      const Run all = run(words);
      std::printf("%-5s %-14s %6.2f s  processors %6.2f s  %4.0f MB\n", model.c_str(), proof ? "with the proof" : "without",
                  all.seconds, all.processor_seconds, all.megabytes);
      worst = std::max(worst, all.code);
    }
  }
  Run one;
  one.seconds = 1e9;
  for (int i = 0; i < 20; ++i) {
    const Run again = run({FCA_IO, "convert", (folder / "in/0.yaml").string(), "--to", "orbslam3", "--model", "kb4", "-o",
                           (folder / "one.yaml").string(), "--force"});
    if (again.seconds < one.seconds) one = again;
  }
  std::printf("one file: %.1f empty programs\n", one.seconds / empty);
  fs::remove_all(folder);
  return worst;
}
