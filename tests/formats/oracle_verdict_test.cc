// SPDX-License-Identifier: BSD-3-Clause
// The verdict about pixels, judged by what the real programs computed (oracles/) and not by our imitations of them. The folder
// is not part of the repository; without it all is skipped.
#include "formats/oracle_table.h"

#include <gtest/gtest.h>

#include <fca/formats/proof.h>
#include <fca/formats/verdict.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace fca::test {
namespace {

/// The tables of a program of ours, and where they lie.
struct Printed {
  const char* program;
  const char* folder;
  const char* suffix;
};

constexpr std::array kPrinted = {
    Printed{"kalibr", "kalibr", "kalibr"},          Printed{"orbslam3", "orbslam3", "orbslam3"},
    Printed{"opencv", "opencv", "opencv"},          Printed{"ocamcalib", "ocamcalib", "ocamcalib"},
    Printed{"woodscape", "woodscape", "woodscape"}, Printed{"basalt", "basalt", "basalt"},
    Printed{"vins", "camodocal", "camodocal"},      Printed{"ros", "ros_camera_info", "ros"},
};

constexpr double kReadyPx = 0.25;

/// The camera's own pixels of a region beside those that a program printed.
struct Judgement {
  int compared = 0;
  double rms = 0.0;
};

/// Where the verdict looks: the image, of a wide lens the circle in it.
bool is_in_region(const Camera& camera, const Pixel& pixel, bool is_wide) {
  const Pixel last = {camera.image_size->width - 1.0, camera.image_size->height - 1.0};
  if (pixel[0] < 0.0 || pixel[1] < 0.0 || pixel[0] > last[0] || pixel[1] > last[1]) return false;
  const Pixel middle = {0.5 * last[0], 0.5 * last[1]};
  return !is_wide || distance(pixel, middle) <= std::min(middle[0], middle[1]);
}

using ProjectRay = std::function<std::optional<Pixel>(const Ray&)>;

/// `theirs`: the pixels that are to be the table's, in the file's.
Judgement judge(const Camera& camera, const OracleTable& table, const std::array<double, 2>& scale, bool is_wide,
                const ProjectRay& theirs) {
  Judgement result;
  double squares = 0.0;
  for (const OracleRow& row : table.rows) {
    const std::optional<Pixel> pixel = project(camera.model, row.ray);
    // From 90 degrees on programs mirror: the verdict counts that as a share, not as pixels.
    if (!pixel || row.ray[2] <= 0.0 || !is_in_region(camera, *pixel, is_wide) || std::isnan(row.pixel[0])) continue;
    const std::optional<Pixel> seen = theirs(row.ray);
    if (!seen) continue;
    squares += std::pow(distance(*seen, {row.pixel[0] / scale[0], row.pixel[1] / scale[1]}), 2);
    ++result.compared;
  }
  if (result.compared > 0) result.rms = std::sqrt(squares / result.compared);
  return result;
}

/// A proof of the table's file, and the camera that the table is about.
struct Case {
  Camera camera;
  CameraProof proof;
  consumers::ConsumerCamera reader;
};

ProjectRay by_model(const Camera& camera) {
  return [&camera](const Ray& ray) { return project(camera.model, ray); };
}

/// In the file's pixels.
ProjectRay by_reader(const consumers::ConsumerCamera& reader) {
  return [&reader](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> pixel = reader.project(ray);
    if (!pixel) return std::nullopt;
    return Pixel{(*pixel)[0] / reader.scale[0], (*pixel)[1] / reader.scale[1]};
  };
}

std::optional<Case> case_of(const consumers::Consumer& consumer, const OracleTable& table) {
  const std::string bytes = read_file(shared_dir() / "corpus" / table.file);
  const ReadCorpusFile read = read_corpus_file(table.file);
  if (!read.calibration || read.calibration->rig.cameras.size() <= table.camera) return std::nullopt;
  const Camera& camera = read.calibration->rig.cameras[table.camera];
  if (!camera.image_size) return std::nullopt;
  for (const char* mode : {"mono", "stereo"}) {
    const consumers::LoadOptions options = {mode, ""};
    const ProofResult proof = prove(consumer, bytes, options, read.calibration->rig);
    const consumers::ConsumerView view = consumer.load(bytes, options);
    if (!proof.loads || proof.cameras.size() <= table.camera || view.cameras.size() <= table.camera) continue;
    return Case{camera, proof.cameras[table.camera], view.cameras[table.camera]};
  }
  return std::nullopt;
}

/// What the verdict says of a table's camera, beside what the program computed.
struct Verdicts {
  int tables = 0;
  int ready = 0;
  std::vector<std::string> wrong;
};

void judge_table(const consumers::Consumer& consumer, const OracleTable& table, Verdicts& verdicts) {
  const std::optional<Case> one = case_of(consumer, table);
  if (!one) return;
  const PixelDistance& said = one->proof.distance.decisive();
  const Judgement real = judge(one->camera, table, one->reader.scale, one->proof.distance.is_wide, by_model(one->camera));
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

Verdicts judge_tables(const consumers::Consumer& consumer, const Printed& printed) {
  Verdicts verdicts;
  for (const OracleTable& table : oracle_tables(printed.folder, printed.suffix)) judge_table(consumer, table, verdicts);
  return verdicts;
}

TEST(OracleVerdict, ReadyIsWhatTheRealProgramUnderstands) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int tables = 0;
  int ready = 0;
  for (const Printed& printed : kPrinted) {
    const Verdicts verdicts = judge_tables(*consumers::find_consumer(printed.program), printed);
    std::printf("%-10s %d cameras, %d ready\n", printed.program, verdicts.tables, verdicts.ready);
    for (const std::string& wrong : verdicts.wrong) ADD_FAILURE() << printed.program << ": " << wrong;
    tables += verdicts.tables;
    ready += verdicts.ready;
  }
  EXPECT_GE(tables, 50);
  EXPECT_GE(ready, 30);
  EXPECT_LT(ready, tables) << "real files that their program misreads are among them";
}

/// The table's camera, written anew for its program, as our imitation reads the new file; nothing where the program misreads
/// the old one.
std::optional<Case> written_anew(const consumers::Consumer& consumer, const OracleTable& table) {
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
  const ProofResult proof = prove(consumer, bytes, {"mono", ""}, rig);
  const consumers::ConsumerView view = consumer.load(bytes, {"mono", ""});
  if (!proof.loads || proof.cameras.size() != 1) return std::nullopt;
  return Case{old->camera, proof.cameras.front(), view.cameras.front()};
}

// What is written from such a camera and called ready has the pixels that the program computed of the old file.
TEST(OracleVerdict, WhatIsWrittenAnewAndReadyHasTheProgramsPixels) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int ready = 0;
  for (const Printed& printed : kPrinted) {
    const consumers::Consumer& consumer = *consumers::find_consumer(printed.program);
    for (const OracleTable& table : oracle_tables(printed.folder, printed.suffix)) {
      const std::optional<Case> anew = written_anew(consumer, table);
      const std::optional<Case> old = case_of(consumer, table);
      if (!anew || word_of(anew->proof.distance.decisive()) != VerdictWord::kReady) continue;
      const Judgement real =
          judge(anew->camera, table, old->reader.scale, anew->proof.distance.is_wide, by_reader(anew->reader));
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

// The judge can fail: a wrong coefficient in one of our imitations makes its verdicts differ from what the program computed.
TEST(OracleVerdict, AWrongImitationIsFoundOut) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  consumers::Consumer wrong = *consumers::find_consumer("kalibr");
  wrong.load = &load_wrong;
  const Verdicts verdicts = judge_tables(wrong, kPrinted.front());
  EXPECT_GE(verdicts.wrong.size(), 5U);
}

}  // namespace
}  // namespace fca::test
