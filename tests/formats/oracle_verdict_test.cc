// SPDX-License-Identifier: BSD-3-Clause
// The verdict about pixels, checked against what the real programs computed (oracles/) and not by our imitations of them. The
// folder is not part of the repository; without it all is skipped.
#include "formats/oracle_distance.h"

#include <gtest/gtest.h>

#include <fca/formats/verdict.h>

#include <cmath>
#include <cstdio>

namespace fca::test {
namespace {

ProjectRay by_model(const Camera& camera) {
  return [&camera](const Ray& ray) { return project(camera.model, ray); };
}

/// What the verdict says of a table's camera, next to what the program computed.
struct Verdicts {
  int tables = 0;
  int ready = 0;
  std::vector<std::string> wrong;
};

void evaluate_table(const consumers::Consumer& consumer, const OracleTable& table, Verdicts& verdicts) {
  const std::optional<Case> one = case_of(consumer, table);
  if (!one) return;
  const PixelDistance& said = one->proof.distance.decisive();
  const OracleDistance real =
      evaluate(one->camera, table, one->reader.scale, one->proof.distance.is_wide, by_model(one->camera));
  if (real.compared == 0) return;
  ++verdicts.tables;
  const bool ready = word_of(said) == VerdictWord::kReady;
  verdicts.ready += ready ? 1 : 0;
  // The table has other rays than the verdict: of a camera between the two limits either may be right.
  constexpr double kSurelyGoodPx = 0.05;
  const bool wrong = ready ? real.rms > kReadyPx : real.rms < kSurelyGoodPx;
  if (!wrong) return;
  std::array<char, 300> line{};
  std::snprintf(line.data(), line.size(), "%s cam%zu: the verdict measured %.3g px rms, the program %.3g px over %d rays",
                table.file.c_str(), table.camera, said.rms, real.rms, real.compared);
  verdicts.wrong.emplace_back(line.data());
}

Verdicts evaluate_tables(const consumers::Consumer& consumer, const Printed& printed) {
  Verdicts verdicts;
  for (const OracleTable& table : oracle_tables(printed.folder, printed.suffix)) evaluate_table(consumer, table, verdicts);
  return verdicts;
}

TEST(OracleVerdict, ReadyIsWhatTheRealProgramUnderstands) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int tables = 0;
  int ready = 0;
  for (const Printed& printed : kPrinted) {
    const Verdicts verdicts = evaluate_tables(*consumers::find_consumer(printed.program), printed);
    std::printf("%-10s %d cameras, %d ready\n", printed.program, verdicts.tables, verdicts.ready);
    for (const std::string& wrong : verdicts.wrong) ADD_FAILURE() << printed.program << ": " << wrong;
    tables += verdicts.tables;
    ready += verdicts.ready;
  }
  EXPECT_GE(tables, 50);
  EXPECT_GE(ready, 30);
  EXPECT_LT(ready, tables) << "real files that their program misreads are among them";
}

/// The table's camera, rewritten for its program, as our imitation reads the new file; nothing where the program misreads
/// the old one.
std::optional<Case> rewritten_case(const consumers::Consumer& consumer, const OracleTable& table) {
  const std::optional<Case> old = case_of(consumer, table);
  if (!old || old->proof.misread || word_of(old->proof.distance.decisive()) != VerdictWord::kReady) return std::nullopt;
  Rig rig;
  rig.cameras = {old->camera};
  WriteOptions options;
  options.sensor = "mono";
  Diagnostics diagnostics;
  const std::optional<Written> written = find_format(consumer.format)->write(nullptr, rig, options, diagnostics);
  if (!written || written->files.front().cameras.empty()) return std::nullopt;
  const std::string bytes = written->files.front().document.bytes();
  const ProofResult proof = prove(consumer, bytes, {"mono", std::nullopt}, rig);
  const consumers::ConsumerView view = consumer.load(bytes, {"mono", std::nullopt});
  if (!proof.loads || proof.cameras.size() != 1) return std::nullopt;
  return Case{old->camera, proof.cameras.front(), view.cameras.front()};
}

// What is written from such a camera and called ready has the pixels that the program computed of the old file.
TEST(OracleVerdict, WhatIsRewrittenAndReadyHasTheProgramsPixels) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int ready = 0;
  for (const Printed& printed : kPrinted) {
    const consumers::Consumer& consumer = *consumers::find_consumer(printed.program);
    for (const OracleTable& table : oracle_tables(printed.folder, printed.suffix)) {
      const std::optional<Case> rewritten = rewritten_case(consumer, table);
      const std::optional<Case> old = case_of(consumer, table);
      if (!rewritten || word_of(rewritten->proof.distance.decisive()) != VerdictWord::kReady) continue;
      const OracleDistance real = evaluate(rewritten->camera, table, old->reader.scale, rewritten->proof.distance.is_wide,
                                           by_reader(rewritten->reader));
      ++ready;
      EXPECT_LE(real.rms, kReadyPx) << table.file << " cam" << table.camera;
    }
  }
  EXPECT_GE(ready, 30);
}

/// Kalibr's reader with k1 a hundredth too large, as far as pixels show it.
consumers::ConsumerView load_wrong(std::string_view bytes, const consumers::LoadOptions& options) {
  consumers::ConsumerView view = consumers::find_consumer("kalibr")->load(bytes, options);
  for (consumers::ConsumerCamera& camera : view.cameras) {
    camera.project = [right = camera.project](const Ray& ray) {
      std::optional<Pixel> pixel = right(ray);
      const double angle = std::atan2(std::hypot(ray[0], ray[1]), ray[2]);
      const std::optional<Pixel> axis = right({0.0, 0.0, 1.0});
      constexpr double kWrong = 0.01;
      for (std::size_t i = 0; pixel && axis && i < 2; ++i) (*pixel)[i] += kWrong * angle * angle * ((*pixel)[i] - (*axis)[i]);
      return pixel;
    };
  }
  return view;
}

// The verdict can fail: a wrong coefficient in one of our imitations makes its verdicts differ from what the program computed.
TEST(OracleVerdict, AWrongImitationIsFoundOut) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  consumers::Consumer wrong = *consumers::find_consumer("kalibr");
  wrong.load = &load_wrong;
  const Verdicts verdicts = evaluate_tables(wrong, kPrinted.front());
  EXPECT_GE(verdicts.wrong.size(), 5U);
}

}  // namespace
}  // namespace fca::test
