// SPDX-License-Identifier: BSD-3-Clause
// A program's start and a whole conversion, as the shell pays for them, next to an empty C++ program: their ratio is what
// compares between machines. Wall-clock time, as the processor time of children is not counted.
#include "child.h"

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>
#include <vector>

namespace {

void process(benchmark::State& state, const std::vector<std::string>& words) {
  for (auto _ : state) {
    if (fca::bench::run(words).code == 0) continue;
    state.SkipWithError("the program failed");
    return;
  }
}

const bool kRegistered = [] {
  const std::string chain = std::string(FCA_TESTDATA_DIR) + "/formats/kalibr/good/ds.yaml";  // two cameras
  const std::string output = (std::filesystem::temp_directory_path() / "fca-io-bench.yaml").string();
  const auto add = [](const char* name, const std::vector<std::string>& words) {
    benchmark::RegisterBenchmark(name, [=](benchmark::State& state) { process(state, words); })->UseRealTime();
  };
  add("process/empty", {FCA_EMPTY_PROGRAM});
  add("process/version", {FCA_IO, "--version"});
  add("process/same-format", {FCA_IO, "convert", chain, "--to", "kalibr", "--model", "kb4", "-o", output, "--force"});
  add("process/same-format-97.5-deg",
      {FCA_IO, "convert", chain, "--to", "kalibr", "--model", "kb4", "--max-angle", "97.5", "-o", output, "--force"});
  add("process/orbslam3-97.5-deg",
      {FCA_IO, "convert", chain, "--to", "orbslam3", "--max-angle", "97.5", "-o", output, "--force"});
  add("process/kept", {FCA_IO, "convert", chain, "--to", "kalibr", "-o", output, "--force"});
  add("process/orbslam3", {FCA_IO, "convert", chain, "--to", "orbslam3", "-o", output, "--force"});
  return true;
}();

}  // namespace
