// SPDX-License-Identifier: BSD-3-Clause
// Real files of corpus/{ocamcalib,woodscape,tumvi} and extra/dso_camera_txt: nothing else of the corpus is taken for one of
// these formats, inverse polynomials rewritten are good, and the pixels are those of their own programs. corpus_test.cc has
// the table of what is read and refused.
#include "formats/oracle_table.h"

#include <fca/formats/proof.h>
#include <fca/formats/wording.h>

#include <cstdio>

namespace fca::test {
namespace {

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const fs::path& path : files_in(shared_dir() / "corpus" / folder))
    names.push_back(folder + "/" + path.filename().string());
  return names;
}

// Next to the formats' own folders (corpus_test.cc has their table).
TEST(WordsCorpus, DsoFilesAreReadAndWrittenBack) {
  if (!has_shared()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const std::vector<std::string> files = names_in("extra/dso_camera_txt");
  EXPECT_EQ(files.size(), 4U);
  for (const std::string& file : files) {
    const ReadCorpusFile outcome = read_corpus_file(file);
    ASSERT_TRUE(outcome.calibration) << file;
    EXPECT_EQ(outcome.calibration->format->id, "dso") << file;
    const Written written =
        written_by(*outcome.calibration->format, &outcome.calibration->documents.front(), outcome.calibration->rig);
    ASSERT_EQ(written.files.size(), 1U) << file;
    EXPECT_EQ(written.files.front().document.bytes(), read_file(shared_dir() / "corpus" / file)) << file;
  }
}

/// How far world2cam, by the polynomial written, is from the lens, over the pixels of the image.
double world2cam_error(const Rig& rig, const std::string& bytes) {
  const consumers::ConsumerView view = consumers::find_consumer("ocamcalib")->load(bytes, {});
  EXPECT_TRUE(view.loads());
  if (!view.loads()) return HUGE_VAL;
  constexpr int kSteps = 64;
  const Camera& camera = rig.cameras.front();
  double worst = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Pixel pixel = {(camera.image_size->width - 1.0) * i / kSteps, (camera.image_size->height - 1.0) * j / kSteps};
      const std::optional<Ray> ray = unproject(camera.model, pixel);
      if (!ray) continue;
      const auto theirs = view.cameras.front().project(*ray);
      EXPECT_TRUE(theirs);
      if (theirs) worst = std::max(worst, distance(pixel, {(*theirs)[0], (*theirs)[1]}));
    }
  }
  return worst;
}

// Every real lens, its inverse polynomial removed: the one that is rewritten is within 1e-6 px over the whole lens.
TEST(WordsCorpus, TheInverseWrittenIsWithinAMillionthOfAPixel) {
  if (!has_shared()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  int lenses = 0;
  double worst = 0.0;
  for (const std::string& file : names_in("ocamcalib")) {
    SCOPED_TRACE(file);
    const ReadCorpusFile outcome = read_corpus_file(file);
    ASSERT_TRUE(outcome.calibration);
    Rig rig = outcome.calibration->rig;
    std::erase_if(rig.extra_fields, [](const ExtraField& extra) { return extra.key == "inverse polynomial"; });
    Diagnostics diagnostics;
    const std::optional<Written> written = outcome.calibration->format->write(nullptr, rig, {}, diagnostics);
    ASSERT_TRUE(written);
    EXPECT_TRUE(diagnostics.entries().empty()) << message_of(diagnostics.entries().front());
    const double error = world2cam_error(rig, written->files.front().document.bytes());
    EXPECT_LE(error, 1e-6);
    worst = std::max(worst, error);
    ++lenses;
  }
  std::printf("%d lenses, worst %.2g px\n", lenses, worst);
  EXPECT_GE(lenses, 48);
}

TEST(WordsCorpus, NothingElseIsTakenForThese) {
  if (!has_shared()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  int asked = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(shared_dir() / "corpus")) {
    const std::string file = fs::relative(entry.path(), shared_dir() / "corpus").string();
    if (!entry.is_regular_file() || file.find('/') == std::string::npos) continue;
    const bool ours = file.starts_with("ocamcalib/") || file.starts_with("woodscape/") || file.starts_with("tumvi/") ||
                      file.starts_with("extra/dso_camera_txt/");
    if (ours) continue;
    Diagnostics ignored;
    const std::optional<text::Document> document = text::read_document(entry.path().string(), ignored);
    if (!document) continue;
    ++asked;
    for (const char* id : {"ocamcalib", "woodscape", "tumvi"})
      EXPECT_EQ(find_format(id)->probe(*document).score, 0)
          << file << ": " << text::text_of(find_format(id)->probe(*document).why);
  }
  EXPECT_GT(asked, 200);
}

/// A program's table against the model that our reader gives. Rows where the program has no pixel, or where we have none
/// because the lens's radius no longer grows there, are counted, not compared.
struct Counts {
  int compared = 0;
  int nan = 0;
  int outside = 0;
  double worst = 0.0;
};

/// DSO and Kalibr divide by z: behind the camera they print the mirror image.
Counts compare(const OracleTable& table, const CameraModel& model, bool in_front_only, double far_px) {
  Counts counts;
  for (const OracleRow& row : table.rows) {
    if (std::isnan(row.pixel[0])) {
      ++counts.nan;
      continue;
    }
    const std::optional<Pixel> ours = project(model, row.ray);
    const double size = std::max(std::abs(row.pixel[0]), std::abs(row.pixel[1]));
    if (!ours || (in_front_only && row.ray[2] <= 0.0) || size > far_px) {
      ++counts.outside;
      continue;
    }
    ++counts.compared;
    counts.worst = std::max(counts.worst, distance(*ours, row.pixel) / std::max(1.0, size / 1000.0));
  }
  return counts;
}

void print(const OracleTable& table, const Counts& counts) {
  std::printf("%-110s %4d compared %4d nan %4d outside  worst %.2g px\n", table.file.c_str(), counts.compared, counts.nan,
              counts.outside, counts.worst);
}

// OCamCalib projects by the file's inverse polynomial, we by the exact inverse of the direct one: the tables agree with us as
// far as the file's two polynomials agree with each other.
TEST(WordsOracle, OCamCalibWithinTheFilesOwnInverse) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int tables = 0;
  for (const OracleTable& table : oracle_tables("ocamcalib", "ocamcalib")) {
    const ReadCorpusFile outcome = read_corpus_file(table.file);
    ASSERT_TRUE(outcome.calibration) << table.file;
    const Camera& camera = outcome.calibration->rig.cameras.front();
    // Inside the image only: outside of it nobody fitted the file's inverse.
    OracleTable inside = table;
    std::erase_if(inside.rows, [&camera](const OracleRow& row) {
      return !(row.pixel[0] >= 0.0 && row.pixel[1] >= 0.0 && row.pixel[0] <= camera.image_size->width - 1.0 &&
               row.pixel[1] <= camera.image_size->height - 1.0);
    });
    const std::string bytes = read_file(shared_dir() / "corpus" / table.file);
    const double own = consumers::find_consumer("ocamcalib")->load(bytes, {}).cameras.at(0).approximation_px;
    const Counts counts = compare(inside, camera.model, false, HUGE_VAL);
    print(table, counts);
    EXPECT_GE(counts.compared, 25) << table.file;
    // The consumer measures on a lattice: a little more is possible between its points.
    EXPECT_LE(counts.worst, 1.05 * own + 1e-9) << table.file << ": the file's own inverse is off by " << own;
    ++tables;
  }
  EXPECT_GE(tables, 14);
}

TEST(WordsOracle, WoodScape) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  for (const OracleTable& table : oracle_tables("woodscape", "woodscape")) {
    const ReadCorpusFile outcome = read_corpus_file(table.file);
    ASSERT_TRUE(outcome.calibration) << table.file;
    const Counts counts = compare(table, outcome.calibration->rig.cameras.front().model, false, HUGE_VAL);
    print(table, counts);
    EXPECT_GT(counts.compared, 60);
    EXPECT_LE(counts.worst, 1e-9);
  }
}

TEST(WordsOracle, DsoCameraTxt) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int tables = 0;
  for (const char* folder : {"dso_camera_txt", "tumvi"}) {
    for (const OracleTable& table : oracle_tables(folder, "dso")) {
      const ReadCorpusFile outcome = read_corpus_file(table.file);
      ASSERT_TRUE(outcome.calibration) << table.file;
      // Farther out the rounding of DSO's floats is multiplied by the polynomial (consumers_oracle_files_test.cc).
      const Counts counts = compare(table, outcome.calibration->rig.cameras.front().model, true, 1e4);
      print(table, counts);
      EXPECT_GT(counts.compared, 20) << table.file;
      EXPECT_LE(counts.worst, 2e-4) << table.file;
      ++tables;
    }
  }
  EXPECT_GE(tables, 5);
}

TEST(WordsOracle, TumViChains) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int tables = 0;
  for (const auto& [consumer, tolerance] : {std::pair{"kalibr", 1e-9}, std::pair{"openvins", 2e-4}}) {
    for (const OracleTable& table : oracle_tables("tumvi", consumer)) {
      const ReadCorpusFile outcome = read_corpus_file(table.file);
      ASSERT_TRUE(outcome.calibration) << table.file;
      const Counts counts = compare(table, outcome.calibration->rig.cameras.at(table.camera).model, true, HUGE_VAL);
      print(table, counts);
      EXPECT_GE(counts.compared, 25) << table.file;
      EXPECT_LE(counts.worst, tolerance) << table.file;
      ++tables;
    }
  }
  EXPECT_GE(tables, 4);
}

}  // namespace
}  // namespace fca::test
