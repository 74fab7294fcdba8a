// SPDX-License-Identifier: BSD-3-Clause
// ocamcalib and woodscape against what OCamCalib's C functions and WoodScape's projection.py printed for real files (the tables
// of oracles/README.md). The files are read here in their plainest form; the formats have their own tests.
#include "model_test_support.h"

#include <filesystem>

namespace fca::test {
namespace {

namespace fs = std::filesystem;

struct OracleRow {
  bool project = false;
  Ray ray;
  Pixel pixel;
};

struct OracleTable {
  std::string file;  ///< Below corpus/.
  std::vector<OracleRow> rows;
};

std::vector<OracleTable> tables_of(const std::string& consumer) {
  std::vector<OracleTable> tables;
  const fs::path folder = fs::path(FCA_SHARED_DIR) / "oracles" / consumer;
  if (!fs::exists(folder)) return tables;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    OracleTable table;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      const std::vector<std::string> f = fields_of(line);
      const std::string first = "# corpus file: ";
      if (line.starts_with(first)) table.file = f[0].substr(first.size());
      if (f.size() < 6) continue;
      const auto n = [&f](std::size_t i) { return number_in(f[i]); };
      if (f[0] == "project") table.rows.push_back({true, {n(1), n(2), n(3)}, {n(4), n(5)}});
      if (f[0] == "unproject") table.rows.push_back({false, {n(3), n(4), n(5)}, {n(1), n(2)}});
    }
    tables.push_back(table);
  }
  return tables;
}

/// The numbers of an OCamCalib file: block after block, comments left out.
Intrinsics<Ocamcalib> ocam_file(const fs::path& path) {
  std::ifstream stream(path);
  std::vector<double> numbers;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    for (double number = 0.0; words >> number;) numbers.push_back(number);
  }
  Intrinsics<Ocamcalib> camera;
  const auto terms = static_cast<std::size_t>(numbers.at(0));
  EXPECT_LE(terms, 9U) << path;
  std::copy_n(numbers.begin() + 1, terms, camera.values.begin() + 5);
  const std::size_t centre = 2 + terms + static_cast<std::size_t>(numbers.at(1 + terms));
  camera.values[1] = numbers.at(centre);  // row
  camera.values[0] = numbers.at(centre + 1);
  for (std::size_t i = 0; i < 3; ++i) camera.values[2 + i] = numbers.at(centre + 2 + i);
  return camera;
}

double number_after(const std::string& text, const std::string& key) {
  const std::size_t at = text.find("\"" + key + "\":");
  return at == std::string::npos ? std::numeric_limits<double>::quiet_NaN() : std::stod(text.substr(at + key.size() + 3));
}

Intrinsics<Woodscape> woodscape_file(const fs::path& path) {
  std::ifstream stream(path);
  std::stringstream text;
  text << stream.rdbuf();
  const auto n = [content = text.str()](const char* key) { return number_after(content, key); };
  return {{n("k1"), n("k2"), n("k3"), n("k4"), n("aspect_ratio"), 0.5 * n("width") - 0.5 + n("cx_offset"),
           0.5 * n("height") - 0.5 + n("cy_offset")}};
}

// cam2world uses the direct polynomial, as we do; world2cam the file's inverse polynomial, a separate fit that is off by a
// fraction of a pixel where the toolbox fitted it and by anything beyond.
TEST(ModelOracles, Ocamcalib) {
  const std::vector<OracleTable> tables = tables_of("ocamcalib");
  if (tables.empty()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int rays = 0;
  int pixels = 0;
  double worst_ray = 0.0;
  std::vector<double> distances;
  for (const OracleTable& table : tables) {
    SCOPED_TRACE(table.file);
    const CameraModel camera = ocam_file(fs::path(FCA_SHARED_DIR) / "corpus" / table.file);
    for (const OracleRow& row : table.rows) {
      if (!std::isfinite(row.ray[0]) || !std::isfinite(row.pixel[0])) continue;
      if (row.project) {
        const auto pixel = project(camera, row.ray);
        if (!pixel) continue;
        ++pixels;
        distances.push_back(std::hypot((*pixel)[0] - row.pixel[0], (*pixel)[1] - row.pixel[1]));
        continue;
      }
      const auto ray = unproject(camera, row.pixel);
      if (!ray) continue;
      ++rays;
      worst_ray = std::max(worst_ray, angle_between(*ray, row.ray));
    }
  }
  std::ranges::sort(distances);
  ASSERT_GT(rays, 200);
  ASSERT_GT(pixels, 500);
  const double median = distances[distances.size() / 2];
  std::printf("  %d rays, worst %.2g rad; %d pixels, median %.2g px off their inverse polynomial\n", rays, worst_ray, pixels,
              median);
  EXPECT_LE(worst_ray, 1e-12);
  EXPECT_LE(median, 0.1);
}

TEST(ModelOracles, Woodscape) {
  const std::vector<OracleTable> tables = tables_of("woodscape");
  if (tables.empty()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int compared = 0;
  for (const OracleTable& table : tables) {
    SCOPED_TRACE(table.file);
    const CameraModel camera = woodscape_file(fs::path(FCA_SHARED_DIR) / "corpus" / table.file);
    for (const OracleRow& row : table.rows) {
      if (!std::isfinite(row.ray[0]) || !std::isfinite(row.pixel[0])) continue;
      if (row.project) {
        const auto pixel = project(camera, row.ray);
        if (!pixel) continue;
        ++compared;
        EXPECT_LE(std::hypot((*pixel)[0] - row.pixel[0], (*pixel)[1] - row.pixel[1]), 1e-9);
      } else if (const auto ray = unproject(camera, row.pixel)) {
        ++compared;
        EXPECT_LE(angle_between(*ray, row.ray), 1e-9);
      }
    }
  }
  EXPECT_GT(compared, 40);
}

}  // namespace
}  // namespace fca::test
