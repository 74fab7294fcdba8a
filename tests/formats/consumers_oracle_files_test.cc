// SPDX-License-Identifier: BSD-3-Clause
// The consumers of OpenCV, OCamCalib, WoodScape and DSO against what the real programs printed (oracles/), and their verdicts
// against oracles/SUMMARY.tsv. The folder is not part of the repository; without it all is skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fca/formats/consumers/consumer.h"
#include "test_files.h"

#include <fca/formats/wording.h>

namespace fca::consumers {
namespace {

using test::shared_dir;
using test::fs::path;

bool has_oracles() {
  return test::fs::exists(shared_dir() / "oracles" / "SUMMARY.tsv") &&
         test::fs::exists(shared_dir() / "corpus" / "MANIFEST.tsv");
}

struct Row {
  std::array<double, 3> ray;
  std::array<double, 2> pixel;
};

struct Table {
  std::string file;  ///< Below corpus/.
  std::size_t camera = 0;
  std::vector<Row> rows;
};

Table read_table(const path& name) {
  Table table;
  for (const std::string& line : test::split(test::read_file(name), '\n')) {
    const std::vector<std::string> fields = test::split(line, '\t');
    if (line.starts_with("# corpus file: ")) {
      table.file = fields.at(0).substr(std::string("# corpus file: ").size());
      table.camera = std::stoul(fields.at(1).substr(std::string("camera index: ").size()));
    } else if (!fields.empty() && fields.front() == "project") {
      table.rows.push_back({{std::stod(fields.at(1)), std::stod(fields.at(2)), std::stod(fields.at(3))},
                            {std::stod(fields.at(4)), std::stod(fields.at(5))}});
    }
  }
  return table;
}

struct Comparison {
  int compared = 0;
  int invalid = 0;  ///< Neither has a pixel.
  int excepted = 0;
  int one_sided = 0;   ///< Only one of the two has a pixel.
  double worst = 0.0;  ///< px, scaled to |u| < 1000
};

/// Rows that are not compared to the consumer's tolerance, and why:
/// - The tables of cv::projectPoints and of image_geometry say nan from 90 degrees on, the harness's word: the functions
///   themselves return the mirrored pixel (tests/lib/consumers and tests/programs hold ours against them there).
/// - DSO's floats: more than 10,000 px from the image its polynomial of fifth degree multiplies the rounding of x / z, which
///   depends on the rectified pixel it began with. There 1e-3 px per 1000 is demanded.
bool is_excepted(const Consumer& consumer, const Row& row, const std::optional<std::array<double, 2>>& pixel) {
  if (std::isnan(row.pixel[0])) return (consumer.id == "opencv" || consumer.id == "ros") && row.ray[2] <= 0.0 && pixel;
  constexpr double kFar = 1e4;
  return consumer.id == "dso" && pixel && std::max(std::abs(row.pixel[0]), std::abs(row.pixel[1])) > kFar;
}

Comparison compare(const Consumer& consumer, const ConsumerCamera& camera, const Table& table) {
  Comparison result;
  for (const Row& row : table.rows) {
    const auto pixel = camera.project(row.ray);
    const bool theirs = !std::isnan(row.pixel[0]);
    const bool excepted = is_excepted(consumer, row, pixel);
    if (excepted) ++result.excepted;
    if (excepted && !theirs) continue;
    if (!theirs || !pixel) {
      ++(theirs == pixel.has_value() ? result.invalid : result.one_sided);
      continue;
    }
    const double size = std::max(std::abs(row.pixel[0]), std::abs(row.pixel[1]));
    const double difference = std::max(std::abs((*pixel)[0] - row.pixel[0]), std::abs((*pixel)[1] - row.pixel[1]));
    const double scaled = difference / std::max(1.0, size / 1000.0);
    if (excepted) {
      EXPECT_LE(scaled, 1e-3) << table.file;
      continue;
    }
    ++result.compared;
    result.worst = std::max(result.worst, scaled);
  }
  return result;
}

bool fits(const Comparison& comparison, const Consumer& consumer) {
  return comparison.one_sided == 0 && comparison.compared > 0 && comparison.worst <= consumer.tolerance_px;
}

/// The readings a program may have been told of; the others know only one.
std::vector<LoadOptions> readings(const Consumer& consumer) {
  std::vector<LoadOptions> result(1);
  if (consumer.id != "opencv") return result;
  for (const OpenCvModel model : {OpenCvModel::kPinhole, OpenCvModel::kFisheye}) {
    result.emplace_back();
    result.back().opencv_model = model;
  }
  return result;
}

void compare_tables(const std::string& id, const std::string& folder, const std::string& suffix, std::size_t expected_tables) {
  const Consumer& consumer = *find_consumer(id);
  std::size_t tables = 0;
  for (const path& name : test::files_in(shared_dir() / "oracles" / folder, ".tsv")) {
    if (!name.string().ends_with("." + suffix + ".tsv")) continue;
    ++tables;
    const Table table = read_table(name);
    const std::string bytes = test::read_file(shared_dir() / "corpus" / table.file);
    ASSERT_FALSE(bytes.empty()) << table.file;
    Comparison best;
    std::string told;
    bool found = false;
    for (const LoadOptions& options : readings(consumer)) {
      const ConsumerView view = consumer.load(bytes, options);
      if (!options.opencv_model) {
        EXPECT_TRUE(view.loads()) << table.file << ": " << (view.loads() ? "" : sentence_of(view.refusals.front()));
      }
      if (table.camera >= view.cameras.size()) continue;
      const Comparison comparison = compare(consumer, view.cameras[table.camera], table);
      if (found && !(fits(comparison, consumer) && !fits(best, consumer))) continue;
      found = true;
      best = comparison;
      told = options.opencv_model ? name_of(*options.opencv_model) : "";
    }
    EXPECT_TRUE(fits(best, consumer)) << table.file << ": " << best.worst << " px, " << best.one_sided << " one-sided";
    std::printf("%-140s cam%zu %4d rows %4d nan %4d excepted  max %.2g px%s%s\n", table.file.c_str(), table.camera,
                best.compared, best.invalid, best.excepted, best.worst, told.empty() ? "" : "  read as ", told.c_str());
  }
  EXPECT_GE(tables, expected_tables);
}

TEST(ConsumersOracleFiles, OpenCvTables) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  compare_tables("opencv", "opencv", "opencv", 14);
}

TEST(ConsumersOracleFiles, OCamCalibTables) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  compare_tables("ocamcalib", "ocamcalib", "ocamcalib", 14);
}

TEST(ConsumersOracleFiles, WoodScapeTables) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  compare_tables("woodscape", "woodscape", "woodscape", 1);
}

TEST(ConsumersOracleFiles, DsoTables) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  compare_tables("dso", "dso_camera_txt", "dso", 4);
  compare_tables("dso", "tumvi", "dso", 1);
}

TEST(ConsumersOracleFiles, BasaltTables) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  compare_tables("basalt", "basalt", "basalt", 4);
  compare_tables("basalt", "tumvi", "basalt", 4);
}

TEST(ConsumersOracleFiles, CamodocalTables) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  compare_tables("vins", "camodocal", "camodocal", 14);
}

TEST(ConsumersOracleFiles, RosTables) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  compare_tables("ros", "ros_camera_info", "ros", 4);
}

TEST(ConsumersOracleFiles, TumViChainsAreKalibrs) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  EXPECT_TRUE(find_consumer("kalibr")->reads("tumvi"));
  // The tables themselves are compared with Kalibr's in consumers_oracle_test.cc.
  const ConsumerView view = find_consumer("kalibr")->load(
      test::read_file(shared_dir() / "corpus" / "tumvi" / "lukasvst__dm-vio__configs__tumvi_calib__camchain.yaml"), {});
  EXPECT_TRUE(view.loads());
  EXPECT_EQ(view.cameras.size(), 2U);
}

// Every line of SUMMARY.tsv about these programs: who refuses what.
TEST(ConsumersOracleFiles, VerdictsOfTheSummary) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  std::map<std::string, int> counted;
  for (const std::string& line : test::split(test::read_file(shared_dir() / "oracles" / "SUMMARY.tsv"), '\n')) {
    const std::vector<std::string> fields = test::split(line, '\t');
    if (fields.size() < 4) continue;
    const Consumer* consumer = find_consumer(fields[2]);
    if (consumer == nullptr || fields[2] == "kalibr" || fields[2] == "orbslam3") continue;
    // The harness gave them to the parser of YAML; ROS takes that of .ini by their name.
    if (fields[1].ends_with(".ini")) continue;
    const std::string bytes = test::read_file(shared_dir() / "corpus" / fields[0] / fields[1]);
    ASSERT_FALSE(bytes.empty()) << fields[1];
    // It stopped at the image of the mask, which was not next to the file.
    if (bytes.find("mask: ") != std::string::npos && fields[2] == "svo") continue;
    // It stopped after the first camera, for no reason that is known: a file of the same words is read.
    if (fields[1].ends_with("calib_kitti.yaml") && fields[2] == "svo") continue;
    const bool expected = !fields[3].starts_with("rejected");
    const ConsumerView view = consumer->load(bytes, {});
    EXPECT_EQ(view.loads(), expected) << fields[1] << ": oracle '" << fields[3].substr(0, 100) << "', ours "
                                      << (view.loads() ? "loads" : sentence_of(view.refusals.front()));
    if (view.loads() != expected) std::printf("differs: %s\n", fields[1].c_str());
    ++counted[fields[2] + (expected ? " ok" : " rejected")];
  }
  for (const auto& [what, count] : counted) std::printf("%-24s %d\n", what.c_str(), count);
  EXPECT_GE(counted["woodscape rejected"], 4);
  EXPECT_GE(counted["opencv rejected"], 2);
  EXPECT_GE(counted["dso rejected"], 5);
}

/// Whole folders of real files: which are refused, and why; a file that is refused must be known here.
void list_verdicts(const std::string& id, const std::string& folder, const std::vector<std::string>& refused,
                   const std::string& extension) {
  const Consumer& consumer = *find_consumer(id);
  int loaded = 0;
  for (const path& name : test::files_in(shared_dir() / "corpus" / folder, extension)) {
    const ConsumerView view = consumer.load(test::read_file(name), {});
    const std::string file = name.filename().string();
    const bool expected = std::none_of(refused.begin(), refused.end(),
                                       [&file](const std::string& part) { return file.find(part) != std::string::npos; });
    EXPECT_EQ(view.loads(), expected) << file << ": " << (view.loads() ? "loads" : sentence_of(view.refusals.front()));
    if (!view.loads()) std::printf("%-60s refused: %.120s\n", file.c_str(), sentence_of(view.refusals.front()).c_str());
    for (const std::string& warning : sentences_of(view.warnings))
      std::printf("%-60s warning: %.160s\n", file.c_str(), warning.c_str());
    loaded += view.loads() ? 1 : 0;
  }
  std::printf("%s: %d files load\n", id.c_str(), loaded);
  EXPECT_GT(loaded, 0);
}

TEST(ConsumersOracleFiles, WholeCorpus) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  // Poses without cameras; a misspelt key (Intrisic) and MATLAB's names, which no program of OpenCV's reads.
  list_verdicts("opencv", "opencv", {"extrinsics", "Surround-View", "matlab_stereo_param"}, "");
  list_verdicts("ocamcalib", "ocamcalib", {}, ".txt");
  list_verdicts("woodscape", "woodscape", {"SynWoodScape"}, ".json");
  list_verdicts("woodscape-omnidet", "woodscape", {}, ".json");
  list_verdicts("basalt", "extra/basalt", {"__83e1872", "__9973a89"}, ".json");  // one number for the noise of three axes
  list_verdicts("vins", "extra/camodocal", {}, ".yaml");
  list_verdicts("dso", "extra/dso_camera_txt", {}, ".txt");
  // Those of ROVIO have neither R nor P, which it does not ask for.
  list_verdicts("ros", "extra/ros_camera_info", {"M600", "domi_cam", "euroc_cam"}, "");
}

// world2cam projects with its own polynomial: how far from the other one's inverse, in real files.
TEST(ConsumersOracleFiles, ApproximationOfOCamCalib) {
  if (!has_oracles()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  double worst = 0.0;
  for (const path& name : test::files_in(shared_dir() / "corpus" / "ocamcalib", ".txt")) {
    const ConsumerView view = find_consumer("ocamcalib")->load(test::read_file(name), {});
    if (view.loads()) worst = std::max(worst, view.cameras.front().approximation_px);
  }
  std::printf("largest approximation %.3g px\n", worst);
  EXPECT_GT(worst, 0.0);
}

}  // namespace
}  // namespace fca::consumers
