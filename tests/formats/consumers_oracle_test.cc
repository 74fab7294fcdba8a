// SPDX-License-Identifier: BSD-3-Clause
// Our consumers against what the real programs printed: the tables of oracles/ (one per corpus file and camera), the verdicts
// of oracles/SUMMARY.tsv, and the notes of corpus/MANIFEST.tsv. The folder is not part of the repository; without it all is
// skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "fca/formats/consumers/consumer.h"

#include <fca/formats/wording.h>

#ifndef FCA_SHARED_DIR
#define FCA_SHARED_DIR ""
#endif

namespace fca::consumers {
namespace {

namespace fs = std::filesystem;

fs::path shared_dir() { return FCA_SHARED_DIR; }
bool has_oracles() {
  return fs::exists(shared_dir() / "oracles" / "SUMMARY.tsv") && fs::exists(shared_dir() / "corpus" / "MANIFEST.tsv");
}

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// How a table's program was started, or what has to be done to a file before ours reads it as the oracle did.
struct Exception {
  const char* file;  ///< Part of the corpus file's path.
  int camera;        ///< -1: any.
  const char* sensor;
  const char* cut_at;  ///< Drop the file from this line on; null: whole file.
  const char* reason;
};
constexpr Exception kExceptions[] = {
    {"Monocular__NTU_VIRAL.yaml", 1, "stereo", nullptr, "camera 1 exists only for the stereo sensors"},
    {"4seasons_calib__camchain.yaml", -1, "mono", "T_cam1_cam0",
     "the oracle loaded camera by camera; Kalibr's own chain reader counts the extra top-level key as a camera and stops (see "
     "MANIFEST.tsv)"},
};

const Exception* find_exception(const std::string& file, int camera) {
  for (const Exception& row : kExceptions) {
    if (file.find(row.file) != std::string::npos && (row.camera < 0 || row.camera == camera)) return &row;
  }
  return nullptr;
}

struct Row {
  std::array<double, 3> ray;
  std::array<double, 2> pixel;
};

struct Table {
  fs::path path;
  std::string file;
  int camera = 0;
  std::vector<Row> rows;
};

Table read_table(const fs::path& path) {
  Table table;
  table.path = path;
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> fields = split(line, '\t');
    if (line.starts_with("# corpus file: ")) {
      table.file = fields.at(0).substr(std::string("# corpus file: ").size());
      table.camera = std::stoi(fields.at(1).substr(std::string("camera index: ").size()));
    } else if (fields.at(0) == "project") {
      table.rows.push_back({{std::stod(fields.at(1)), std::stod(fields.at(2)), std::stod(fields.at(3))},
                            {std::stod(fields.at(4)), std::stod(fields.at(5))}});
    }
  }
  return table;
}

std::vector<Table> tables_of(const std::string& consumer) {
  std::vector<Table> tables;
  for (const char* folder : {"kalibr", "orbslam3", "tumvi"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(shared_dir() / "oracles" / folder)) {
      if (entry.path().string().ends_with("." + consumer + ".tsv")) tables.push_back(read_table(entry.path()));
    }
  }
  std::sort(tables.begin(), tables.end(), [](const Table& a, const Table& b) { return a.path < b.path; });
  return tables;
}

struct Comparison {
  int compared = 0;
  int invalid = 0;
  int mirrored = 0;
  double worst = 0.0;
};

double tolerance(const Consumer& consumer, const Row& row) {
  const double size = std::max(std::abs(row.pixel[0]), std::abs(row.pixel[1]));
  // The folded radtan pixels of the tables reach 4e7, where a double has no 1e-9 left.
  return consumer.tolerance_px * std::max(1.0, size / 1000.0);
}

/// Kalibr's tables keep the mirrored pixel of rays with z <= 0 although the program's return value calls it invalid.
bool is_kalibr_mirror(const Consumer& consumer, const Row& row, const ConsumerCamera& camera) {
  return consumer.id == "kalibr" && row.ray[2] <= 0.0 && !camera.project(row.ray);
}

Comparison compare(const Consumer& consumer, const ConsumerCamera& camera, const Table& table) {
  Comparison result;
  for (const Row& row : table.rows) {
    const auto pixel = camera.project(row.ray);
    if (is_kalibr_mirror(consumer, row, camera)) {
      ++result.mirrored;
    } else if (std::isnan(row.pixel[0])) {
      ++result.invalid;
      EXPECT_FALSE(pixel) << table.path << " ray z = " << row.ray[2];
    } else if (!pixel) {
      ADD_FAILURE() << table.path << ": nothing for the ray " << row.ray[0] << " " << row.ray[1] << " " << row.ray[2];
    } else {
      ++result.compared;
      const double difference = std::max(std::abs((*pixel)[0] - row.pixel[0]), std::abs((*pixel)[1] - row.pixel[1]));
      EXPECT_LE(difference, tolerance(consumer, row)) << table.path << " u " << row.pixel[0] << " v " << row.pixel[1];
      result.worst = std::max(result.worst, difference / tolerance(consumer, row) * consumer.tolerance_px);
    }
  }
  return result;
}

/// Which rays must be mirrors: all with z <= 0 of a pinhole table, none of an omni table.
void expect_mirrors(const Table& table, const Comparison& comparison, const std::string& bytes) {
  const auto behind = std::count_if(table.rows.begin(), table.rows.end(), [](const Row& row) { return row.ray[2] <= 0.0; });
  const bool pinhole = bytes.find("camera_model: pinhole") != std::string::npos;
  EXPECT_EQ(comparison.mirrored, pinhole ? behind : 0) << table.path;
}

void compare_all(const std::string& id) {
  const Consumer& consumer = *find_consumer(id);
  const std::vector<Table> tables = tables_of(id);
  EXPECT_GT(tables.size(), 10U);
  std::printf("%-100s %4s %5s %5s %6s  worst px (scaled to |u| < 1000)\n", "file", "cam", "rows", "nan", "mirror");
  for (const Table& table : tables) {
    const Exception* exception = find_exception(table.file, table.camera);
    std::string bytes = read_file(shared_dir() / "corpus" / table.file);
    if (exception != nullptr && exception->cut_at != nullptr) bytes.resize(bytes.find(exception->cut_at));
    const ConsumerView view = consumer.load(bytes, {exception != nullptr ? exception->sensor : "mono"});
    ASSERT_TRUE(view.loads()) << table.file << ": " << sentence_of(view.refusals.front());
    ASSERT_GT(view.cameras.size(), static_cast<std::size_t>(table.camera)) << table.file;
    const Comparison result = compare(consumer, view.cameras.at(static_cast<std::size_t>(table.camera)), table);
    if (id == "kalibr") expect_mirrors(table, result, bytes);
    std::printf("%-100s %4d %5d %5d %6d  %.2g\n", table.file.c_str(), table.camera, result.compared, result.invalid,
                result.mirrored, result.worst);
  }
}

TEST(ConsumersOracle, KalibrTables) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  compare_all("kalibr");
}

TEST(ConsumersOracle, OrbSlam3Tables) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  compare_all("orbslam3");
}

/// Lines of SUMMARY.tsv where the real program's chain reader says otherwise than the oracle, which loaded camera by camera.
bool is_summary_exception(const std::string& file) {
  return find_exception(file, -1) != nullptr && file.find("4seasons") != std::string::npos;
}

int camera_index(const std::string& result) { return result.starts_with("cam") ? std::stoi(result.substr(3)) : 0; }

void check_verdict(const Consumer& consumer, const std::string& format, const std::string& file, const std::string& result) {
  const std::string bytes = read_file(shared_dir() / "corpus" / format / file);
  ASSERT_FALSE(bytes.empty()) << file;
  const bool second_camera = consumer.id == "orbslam3" && camera_index(result) > 0;
  const ConsumerView view = consumer.load(bytes, {second_camera ? "stereo" : "mono"});
  const bool expected = !result.starts_with("rejected");
  EXPECT_EQ(view.loads(), expected && !is_summary_exception(file))
      << file << ": oracle '" << result.substr(0, 100) << "', ours "
      << (view.loads() ? "loads" : sentence_of(view.refusals.front()));
}

TEST(ConsumersOracle, VerdictsOfTheSummary) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  std::map<std::string, int> counted;
  for (const std::string& line : split(read_file(shared_dir() / "oracles" / "SUMMARY.tsv"), '\n')) {
    const std::vector<std::string> fields = split(line, '\t');
    if (fields.size() < 4 || (fields[2] != "kalibr" && fields[2] != "orbslam3")) continue;
    check_verdict(*find_consumer(fields[2]), fields[0], fields[1], fields[3]);
    ++counted[fields[2] + (fields[3].starts_with("rejected") ? " rejected" : " ok")];
  }
  for (const auto& [what, count] : counted) std::printf("%-20s %d\n", what.c_str(), count);
  EXPECT_GE(counted["kalibr rejected"], 10);
  EXPECT_GE(counted["orbslam3 ok"], 15);
}

std::vector<std::pair<std::string, std::string>> manifest_notes(const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> notes;
  for (const std::string& line : split(read_file(shared_dir() / "corpus" / "MANIFEST.tsv"), '\n')) {
    const std::vector<std::string> fields = split(line, '\t');
    if (!fields.empty() && fields[0].starts_with(folder)) notes.emplace_back(fields[0], fields.size() > 6 ? fields[6] : "");
  }
  return notes;
}

// MANIFEST.tsv: "ORB-SLAM3 V1.0 loads as mono/imono | fails: ..." was found with a build of V1.0's Settings.cc.
TEST(ConsumersOracle, SensorModesOfTheManifest) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  constexpr std::pair<const char*, const char*> kModes[] = {{"mono", "mono"},     {"imono", "mono-inertial"},
                                                            {"stereo", "stereo"}, {"istereo", "stereo-inertial"},
                                                            {"rgbd", "rgbd"},     {"irgbd", "rgbd-inertial"}};
  const std::string phrase = "ORB-SLAM3 V1.0 loads as ";
  int checked = 0;
  for (const auto& [file, note] : manifest_notes("orbslam3/")) {
    const std::size_t at = note.find(phrase);
    if (at == std::string::npos) continue;
    const std::string list = note.substr(at + phrase.size(), note.find_first_of(" ;", at + phrase.size()) - at - phrase.size());
    const std::vector<std::string> modes = split(list, '/');
    const std::string bytes = read_file(shared_dir() / "corpus" / file);
    for (const auto& [mode, sensor] : kModes) {
      const bool expected = std::find(modes.begin(), modes.end(), mode) != modes.end();
      const ConsumerView view = find_consumer("orbslam3")->load(bytes, {sensor});
      EXPECT_EQ(view.loads(), expected) << file << " as " << sensor << ": "
                                        << (view.loads() ? "" : sentence_of(view.refusals.front()));
      ++checked;
    }
  }
  std::printf("%d pairs of file and sensor\n", checked);
  EXPECT_GT(checked, 200);
}

bool is_rejected_by_kalibr(const std::string& note) {
  const std::size_t at = note.find("rejected by: ");
  return at != std::string::npos && note.substr(at, note.find(';', at) - at).find("Kalibr") != std::string::npos;
}

// Every file of corpus/kalibr is read by one of Kalibr's two readers unless the manifest says that Kalibr rejects it.
TEST(ConsumersOracle, KalibrFilesOfTheManifest) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int rejected = 0;
  int checked = 0;
  for (const auto& [file, note] : manifest_notes("kalibr/")) {
    const bool expected = !is_rejected_by_kalibr(note);
    const std::string bytes = read_file(shared_dir() / "corpus" / file);
    const ConsumerView chain = find_consumer("kalibr")->load(bytes, {});
    const ConsumerView imu = find_consumer("kalibr-imu")->load(bytes, {});
    EXPECT_EQ(chain.loads() || imu.loads(), expected)
        << file << " [" << note << "]: " << (chain.loads() ? "" : sentence_of(chain.refusals.front())) << " | "
        << (imu.loads() ? "" : sentence_of(imu.refusals.front()));
    ++checked;
    rejected += expected ? 0 : 1;
  }
  std::printf("%d files, %d rejected\n", checked, rejected);
  EXPECT_GT(checked, 50);
}

// The forks read their own examples, except those that say so in the table.
TEST(ConsumersOracle, ForksReadTheirOwnFiles) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int loaded = 0;
  for (const auto& [file, note] : manifest_notes("orbslam3/")) {
    const std::string bytes = read_file(shared_dir() / "corpus" / file);
    if (file.find("raulmur") != std::string::npos) {
      EXPECT_TRUE(find_consumer("orbslam2")->load(bytes, {}).loads()) << file;
    }
    if (note.find("DoubleSphere") != std::string::npos) {
      EXPECT_TRUE(find_consumer("urbste")->load(bytes, {}).loads()) << file;
      EXPECT_FALSE(find_consumer("orbslam3")->load(bytes, {}).loads()) << file;
    }
    if (file.find("ns15417") == std::string::npos) continue;
    const bool named =
        bytes.find("Camera.type: EUCM") != std::string::npos || bytes.find("Camera.type: KB") != std::string::npos;
    const ConsumerView view = find_consumer("slam_no_opt")->load(bytes, {});
    EXPECT_EQ(view.loads(), named) << file << ": " << (view.loads() ? "" : sentence_of(view.refusals.front()));
    loaded += view.loads() ? 1 : 0;
  }
  EXPECT_GE(loaded, 4);
}

// The fork keeps ORB-SLAM3's old-style examples in one folder per sensor; the old parser reads each of them in that mode.
TEST(ConsumersOracle, OldExamplesLoadInTheirMode) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  constexpr std::pair<const char*, const char*> kFolders[] = {
      {"__Monocular__", "mono"}, {"__Monocular-Inertial__", "mono-inertial"},
      {"__Stereo__", "stereo"},  {"__Stereo-Inertial__", "stereo-inertial"},
      {"__RGB-D__", "rgbd"},     {"__RGB-D-Inertial__", "rgbd-inertial"}};
  int checked = 0;
  for (const auto& [file, note] : manifest_notes("orbslam3/")) {
    if (file.find("__Examples_old__") == std::string::npos) continue;
    for (const auto& [folder, sensor] : kFolders) {
      if (file.find(folder) == std::string::npos) continue;
      const ConsumerView view = find_consumer("orbslam3")->load(read_file(shared_dir() / "corpus" / file), {sensor});
      EXPECT_TRUE(view.loads()) << file << ": " << sentence_of(view.refusals.front());
      ++checked;
    }
  }
  std::printf("%d files\n", checked);
  EXPECT_GT(checked, 30);
}

}  // namespace
}  // namespace fca::consumers
