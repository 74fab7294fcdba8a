// SPDX-License-Identifier: BSD-3-Clause
// What is converted from one program's file for another program and called ready: the second sees each ray where the first
// program itself computed it (oracles/). The folder is not part of the repository; without it all is skipped.
#include "formats/oracle_distance.h"

#include <gtest/gtest.h>

#include <fca/fca.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace fca::test {
namespace {

/// Formats whose files each hold a camera whole.
constexpr std::array kTargets = {"kalibr", "orbslam3", "opencv", "openvins", "basalt", "vins", "ocamcalib", "woodscape", "ros"};

ConvertResult converted(const OracleTable& table, const std::string& camera, const char* format) {
  ConvertRequest request;
  request.inputs.files = {(shared_dir() / "corpus" / table.file).string()};
  request.inputs.cameras = {{CameraChoice{camera, table.camera}}};
  request.to = find_format(format);
  request.provenance = ProvenanceComment::kNone;
  Files files;
  return convert(request, files);
}

/// As the program of the proof holds the only camera of what was written; nothing where that is not ready.
std::optional<consumers::ConsumerCamera> seen_by_program(const ConvertResult& result) {
  if (result.status != Status::kDone || result.verdict.word != VerdictWord::kReady || result.proofs.empty())
    return std::nullopt;
  const auto file = std::ranges::find_if(result.files, [](const ConvertedFile& each) { return !each.cameras.empty(); });
  if (file == result.files.end() || file->programs.empty()) return std::nullopt;
  consumers::LoadOptions options;
  options.sensor = result.mode.empty() ? "mono" : result.mode;
  const consumers::ConsumerView view = consumers::find_consumer(file->programs.front())->load(file->bytes, options);
  if (view.cameras.size() != 1) return std::nullopt;
  return view.cameras.front();
}

TEST(OracleVerdict, ReadyForAnotherProgramIsWhatTheFirstComputed) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  std::map<std::string, int> ready;
  for (const Printed& printed : kPrinted) {
    const consumers::Consumer& own = *consumers::find_consumer(printed.program);
    for (const OracleTable& table : oracle_tables(printed.folder, printed.suffix)) {
      // Where the program misreads its file, what it computed is not what the file means.
      const std::optional<Case> original = case_of(own, table);
      if (!original || original->proof.misread || word_of(original->proof.distance.decisive()) != VerdictWord::kReady) continue;
      for (const char* target : kTargets) {
        const auto reader = seen_by_program(converted(table, original->camera.name, target));
        if (!reader) continue;
        const OracleDistance real =
            evaluate(original->camera, table, original->reader.scale, original->proof.distance.is_wide, by_reader(*reader));
        if (real.compared == 0) continue;
        ++ready[target];
        EXPECT_LE(real.rms, kReadyPx) << table.file << " cam" << table.camera << " for " << target;
      }
    }
  }
  for (const auto& [target, count] : ready) std::printf("%-10s %d cameras ready\n", target.c_str(), count);
  EXPECT_GE(ready.size(), 6U) << "programs";
}

}  // namespace
}  // namespace fca::test
