// SPDX-License-Identifier: BSD-3-Clause
// Every real file of the corpus is read, or refused for its actual defect; and what its own program refuses is said so. The
// folder is not part of the repository: without it all is skipped.
#include "formats/test_files.h"

#include <fca/formats/proof.h>
#include <fca/formats/text/message.h>

#include <cstdio>
#include <map>
#include <set>

namespace fca::test {
namespace {

/// A file we refuse, and why it deserves it.
struct Refused {
  const char* file;
  const char* code;
  const char* why;
};

constexpr Refused kRefused[] = {
    {"kalibr/lukasvst__dm-vio__configs__oakd_calib__camchain.yaml", "missing-key",
     "it holds poses only; Kalibr, too, misses camera_model"},
    {"kalibr/mrastgoo__camera_imu_calibration_kalibr_viper__camchain__70a02b7.yaml", "unknown-model",
     "camera_model: onmi/radial"},
    {"kalibr/mrastgoo__camera_imu_calibration_kalibr_viper__camchain_yaml__camchain_Kannala.yaml", "unknown-model",
     "camera_model: pinhole/radial"},
    {"kalibr/mrastgoo__camera_imu_calibration_kalibr_viper__imu_3Dx-GX3-35__11d5c0d.yaml", "merge-conflict",
     "git's markers stand in it"},
    {"kimera/MIT-SPARK__Kimera-VIO__scripts__kalibr__templates__camera.yaml", "yaml-key",
     "a template: {{ camera_id }} stands where a value belongs"},
    {"fast_livo/hku-mars__FAST-LIVO2__config__HILTI22.yaml", "unknown-format", "no camera: poses and tuning"},
    {"fast_livo/hku-mars__FAST-LIVO2__config__NTU_VIRAL.yaml", "unknown-format", "no camera: poses and tuning"},
    {"fast_livo/hku-mars__FAST-LIVO2__config__avia.yaml", "unknown-format", "no camera: poses and tuning"},
};

const Refused* find_refused(const std::string& file) {
  const auto* const found = std::ranges::find(kRefused, file, [](const Refused& row) { return std::string(row.file); });
  return found == std::end(kRefused) ? nullptr : &*found;
}

bool has_corpus() { return fs::exists(shared_dir() / "corpus" / "kalibr"); }

std::vector<fs::path> corpus_files() {
  std::vector<fs::path> files;
  for (const Format& format : all_formats()) {
    const std::vector<fs::path> found = corpus_files_of(format.id);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

/// The format that a file of a folder is to be taken for.
std::string expected_format(const fs::path& path) {
  // TUM-VI's chains (and DM-VIO's settings with noise keys) are Kalibr's, and Basalt has calibrated its cameras, too.
  const fs::path folder = path.parent_path();
  if (folder.filename() == "tumvi" && path.extension() == ".json") return "basalt";
  if (path.filename().string().starts_with("rpng__open_vins")) return "openvins";
  if (folder.filename() == "tumvi" && path.extension() == ".yaml") return "kalibr";
  if (folder.filename() == "tumvi" && path.extension() == ".txt") return "dso";
  const auto* const row = std::ranges::find_if(kSharedFolders, [&folder](const SharedFolders& candidate) {
    return std::ranges::count(corpus_folders(shared_dir(), candidate.format), folder) > 0;
  });
  return row == kSharedFolders.end() ? "" : std::string(row->format);
}

std::string name_of(const fs::path& path) { return path.parent_path().filename().string() + "/" + path.filename().string(); }

struct Outcome {
  std::optional<Calibration> calibration;
  Diagnostics diagnostics;
};

Outcome read(const fs::path& path) {
  Outcome outcome;
  std::optional<text::Document> document = text::read_document(path.string(), outcome.diagnostics);
  ReadOptions options;
  // Of a lens for each size of images one has to be chosen.
  if (path.parent_path().filename() == "zed_conf") options.image_size = ImageSize{1280, 720};
  if (document) outcome.calibration = read_calibration({*std::move(document)}, nullptr, options, outcome.diagnostics);
  return outcome;
}

const Diagnostic* first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity == Severity::kError) return &entry;
  }
  return nullptr;
}

/// What a file was read as, in a line of the table: "kalibr: kb4 kb4 imu0; with warnings program-refuses".
std::string in_words(const Outcome& outcome) {
  const Rig& rig = outcome.calibration->rig;
  std::string line = "read as " + std::string(outcome.calibration->format->id) + ":";
  for (const Camera& camera : rig.cameras) line += " " + std::string(model_info(camera.model).id);
  for (const Imu& imu : rig.imus) line += " " + imu.name;
  if (rig.cameras.empty() && rig.imus.empty()) line += " a pose";
  std::set<std::string> warnings;
  for (const Diagnostic& entry : outcome.diagnostics.entries()) warnings.insert(id_of(entry));
  if (!warnings.empty()) line += "; said";
  for (const std::string& code : warnings) line += " " + code;
  return line;
}

// Prints the table of all formats, one line per file.
TEST(Corpus, EveryFileIsReadOrRefusedForItsDefect) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  std::map<std::string, int> counted;
  std::set<std::string> read_as;
  std::size_t refused = 0;
  for (const fs::path& path : corpus_files()) {
    const std::string name = name_of(path);
    const std::string folder = path.parent_path().filename().string();
    const Outcome outcome = read(path);
    const Refused* expected = find_refused(name);
    const Diagnostic* error = first_error(outcome.diagnostics);
    EXPECT_EQ(outcome.calibration.has_value(), error == nullptr) << name;
    if (outcome.calibration) {
      const Rig& rig = outcome.calibration->rig;
      EXPECT_EQ(expected, nullptr) << name << " is read, and the table says that it is refused";
      EXPECT_EQ(outcome.calibration->format->id, expected_format(path))
          << name << ": " << text::text_of(outcome.calibration->why);
      // COLMAP writes a rig for each camera, though it knows of no pose.
      const bool is_of_single_cameras = path.stem().string().ends_with("rigs");
      EXPECT_EQ(rig.cameras.empty() && rig.imus.empty() && rig.poses.empty(), is_of_single_cameras)
          << name << " is read as nothing at all";
      std::printf("%s: %s\n", name.c_str(), in_words(outcome).c_str());
      read_as.emplace(outcome.calibration->format->id);
      ++counted[folder + ": read as " + std::string(outcome.calibration->format->id)];
      continue;
    }
    ++refused;
    ASSERT_NE(error, nullptr) << name << " is refused without a word";
    ++counted[folder + ": refused by " + id_of(*error)];
    std::printf("%s: refused by %s: %s\n", name.c_str(), id_of(*error).c_str(), message_of(*error).c_str());
    if (expected == nullptr) {
      ADD_FAILURE() << name << " is refused: " << message_of(*error) << " [" << id_of(*error) << "]";
    } else {
      EXPECT_EQ(id_of(*error), expected->code) << name << ": " << expected->why;
    }
  }
  for (const auto& [what, count] : counted) std::printf("%4d %s\n", count, what.c_str());
  EXPECT_EQ(refused, std::size(kRefused));
  for (const Format& format : all_formats()) {
    // A chain of TUM-VI is taken for Kalibr's.
    if (corpus_files_of(format.id).empty() || !format.layout_of.empty()) continue;
    EXPECT_TRUE(read_as.contains(std::string(format.id))) << format.id;
  }
}

TEST(Corpus, ReadAndWrittenBackIsTheSameBytes) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  int compared = 0;
  for (const fs::path& path : corpus_files()) {
    const Outcome outcome = read(path);
    if (!outcome.calibration || !outcome.calibration->format->is_written()) continue;
    const Calibration& calibration = *outcome.calibration;
    Diagnostics diagnostics;
    const std::optional<Written> written =
        calibration.format->write(&calibration.documents.front(), calibration.rig, {}, diagnostics);
    const Diagnostic* error = first_error(diagnostics);
    ASSERT_TRUE(written) << name_of(path) << ": " << (error != nullptr ? message_of(*error) : "nothing said");
    ASSERT_EQ(written->files.size(), 1U) << name_of(path);
    EXPECT_EQ(written->files.front().document.bytes(), read_file(path)) << name_of(path);
    ++compared;
  }
  std::printf("%d files written back\n", compared);
  EXPECT_GT(compared, 250);
}

/// The program a verdict of SUMMARY.tsv is of. Its "orbslam3" had V1.0 and the parser before it, as the program itself.
std::string program_of(const std::string& consumer) { return std::string(consumers::find_consumer(consumer)->program); }

// oracles/SUMMARY.tsv was printed by the real programs. A file they refuse we may read, but we say so.
TEST(Corpus, WhatTheProgramRefusesIsSaid) {
  if (!has_corpus() || !fs::exists(shared_dir() / "oracles" / "SUMMARY.tsv"))
    GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  std::map<std::string, int> refused;
  std::map<std::string, int> loaded;
  for (const std::string& line : split(read_file(shared_dir() / "oracles" / "SUMMARY.tsv"), '\n')) {
    const std::vector<std::string> fields = split(line, '\t');
    if (fields.size() < 4 || fields[0] != fields[2] || (fields[2] != "kalibr" && fields[2] != "orbslam3")) continue;
    const fs::path path = shared_dir() / "corpus" / fields[0] / fields[1];
    const std::string bytes = read_file(path);
    ASSERT_FALSE(bytes.empty()) << path;
    // The oracle loaded this file camera by camera; Kalibr's chain reader counts its extra top-level key as a camera
    // (MANIFEST.tsv).
    if (fields[1].find("4seasons_calib__camchain") != std::string::npos) continue;
    const Readers readers = ask_readers(fields[0], bytes, true);
    const auto program = std::ranges::find(readers.programs, program_of(fields[2]), &Readers::Program::program);
    ASSERT_NE(program, readers.programs.end()) << fields[2];
    const bool rejected = fields[3].starts_with("rejected");
    EXPECT_EQ(program->loads, !rejected) << fields[1] << ": " << fields[3].substr(0, 120);
    if (rejected) {
      EXPECT_FALSE(program->refusals.empty()) << fields[1];
    }
    ++(rejected ? refused : loaded)[fields[2]];
  }
  for (const char* consumer : {"kalibr", "orbslam3"})
    std::printf("%s: %d refused, %d loaded\n", consumer, refused[consumer], loaded[consumer]);
  EXPECT_GE(refused["kalibr"], 10);
  EXPECT_GE(loaded["kalibr"], 15);
  EXPECT_GE(refused["orbslam3"], 25);
  EXPECT_GE(loaded["orbslam3"], 10);
}

}  // namespace
}  // namespace fca::test
