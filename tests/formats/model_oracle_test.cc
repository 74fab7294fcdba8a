// SPDX-License-Identifier: BSD-3-Clause
// What Kalibr and ORB-SLAM3 printed for real files (oracles/README.md), against fca::project on the camera our reader gives.
//
// A row is compared where both have a pixel. Excepted, and counted:
//   nan       the program itself calls the ray invalid;
//   mirrored  the program divides by z and prints the mirror image of a ray at or behind 90 degrees;
//   folded    the program prints a pixel although its image radius has stopped growing on the way out to that ray (we say
//             nothing).
//
// Compared with what the program computes from the file, and counted: rescaled, its image of another size (newWidth x
// newHeight); misread, ORB-SLAM3's second camera with the first one's lens coefficients (FORMATS.md 3.2). Mirrored and folded
// are established from the program's own formula (formats/consumers), not from our answer.
#include "formats/oracle_camera.h"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace fca::test {
namespace {

struct Counts {
  int compared = 0;
  int nan = 0;
  int mirrored = 0;
  int folded = 0;
  int rescaled = 0;    ///< Of those compared.
  int misread = 0;     ///< Of those compared.
  int behind = 0;      ///< Compared at or beyond 90 degrees.
  double worst = 0.0;  ///< In units of what the row allows.
};

/// theta (1 + k1 theta^2 + ... + k4 theta^8) written out here: right at any angle.
Pixel kannala_brandt(const CameraModel& model, const Ray& ray) {
  const auto p = [&model](ParameterId id) { return parameter(model, id).value(); };
  const double r = std::hypot(ray[0], ray[1]);
  const double theta = std::atan2(r, ray[2]);
  const double distorted = theta * (1.0 + p("k1") * std::pow(theta, 2) + p("k2") * std::pow(theta, 4) +
                                    p("k3") * std::pow(theta, 6) + p("k4") * std::pow(theta, 8));
  const double scale = r > 0.0 ? distorted / r : 1.0;
  return {p("fx") * scale * ray[0] + p("cx"), p("fy") * scale * ray[1] + p("cy")};
}

class OracleTables {
 public:
  explicit OracleTables(const std::string& id) : consumer_(*consumers::find_consumer(id)), id_(id) {}

  void compare_all(int fewest_tables) {
    int tables = 0;
    std::printf("%-100s cam compared  (>= 90 deg, rescaled, misread)   nan mirrored folded  worst / allowed\n", "file");
    for (const fs::path& path : files_in(shared_dir() / "oracles" / id_)) {
      if (!path.string().ends_with("." + id_ + ".tsv")) continue;
      const OracleTable table = read_oracle_table(path);
      const Counts counts = compare(table);
      std::printf("%-100s %3zu %8d %11d %9d %8d %7d %8d %6d  %.2g\n", table.file.c_str(), table.camera, counts.compared,
                  counts.behind, counts.rescaled, counts.misread, counts.nan, counts.mirrored, counts.folded, counts.worst);
      ++tables;
      total_ += counts.compared;
      rescaled_ += counts.rescaled;
      misread_ += counts.misread;
    }
    EXPECT_GE(tables, fewest_tables);
  }

  [[nodiscard]] int total() const { return total_; }
  [[nodiscard]] int rescaled() const { return rescaled_; }
  [[nodiscard]] int misread() const { return misread_; }

 private:
  Counts compare(const OracleTable& table) {
    SCOPED_TRACE(table.file);
    Counts counts;
    const std::optional<OracleCamera> camera = oracle_camera(consumer_, table);
    if (!camera) return counts;
    for (const OracleRow& row : table.rows) compare_row(row, camera->in_program, camera->theirs, counts);
    EXPECT_GE(counts.compared, 15) << "too few rows compared";
    if (camera->is_rescaled()) counts.rescaled = counts.compared;
    if (camera->theirs.misread) counts.misread = counts.compared;
    return counts;
  }

  void compare_row(const OracleRow& row, const CameraModel& model, const consumers::ConsumerCamera& theirs, Counts& counts) {
    const std::optional<Pixel> ours = project(model, row.ray);
    const bool kb4 = model_info(model).id == "kb4";
    if (kb4 && ours) {
      EXPECT_LE(distance(*ours, kannala_brandt(model, row.ray)), 1e-9) << "z " << row.ray[2];
    }
    if (std::isnan(row.pixel[0])) {
      ++counts.nan;
      return;
    }
    const bool divides_by_z = id_ == "kalibr" && (kb4 || model_info(model).id == "radtan" ||
                                                  model_info(model).id == "pinhole" || model_info(model).id == "fov");
    const bool v1_pinhole = id_ == "orbslam3" && !kb4;
    if (row.ray[2] <= 0.0 && (divides_by_z || v1_pinhole)) {
      ++counts.mirrored;
      EXPECT_TRUE(kb4 || !ours) << "a pixel for a ray behind a pinhole";
      return;
    }
    if (!ours) {
      ++counts.folded;
      EXPECT_TRUE(folds_before(theirs, row.ray))
          << "we have no pixel for the ray " << row.ray[0] << " " << row.ray[1] << " " << row.ray[2] << ", the program "
          << row.pixel[0] << " " << row.pixel[1] << " and does not fold on the way there";
      return;
    }
    ++counts.compared;
    if (row.ray[2] <= 0.0) ++counts.behind;
    const double tolerance = oracle_tolerance(consumer_, row.pixel);
    const Pixel scaled = {(*ours)[0] * theirs.scale[0], (*ours)[1] * theirs.scale[1]};
    const double difference = distance(scaled, row.pixel);
    EXPECT_LE(difference, tolerance) << "at " << row.pixel[0] << " " << row.pixel[1];
    counts.worst = std::max(counts.worst, difference / tolerance);
  }

  const consumers::Consumer& consumer_;
  std::string id_;
  int total_ = 0;
  int rescaled_ = 0;
  int misread_ = 0;
};

TEST(ModelOracle, Kalibr) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  OracleTables tables("kalibr");
  tables.compare_all(10);
  EXPECT_GE(tables.total(), 400);
}

TEST(ModelOracle, OrbSlam3) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  OracleTables tables("orbslam3");
  tables.compare_all(12);
  EXPECT_GE(tables.total(), 400);
  EXPECT_GE(tables.rescaled(), 15) << "EuRoC's image of newWidth x newHeight";
  EXPECT_GE(tables.misread(), 15) << "the second camera of NTU VIRAL";
}

// Where Kalibr mirrors, the lens does not: a kb4 camera of TUM-VI beyond 90 degrees against the written-out formula.
TEST(ModelOracle, KannalaBrandtIsRightBeyondNinetyDegrees) {
  const Calibration calibration = calibration_of(read_file(testdata_dir() / "kalibr" / "good" / "tumvi.yaml"));
  const CameraModel& model = calibration.rig.cameras.front().model;
  int compared = 0;
  for (double degrees = 80.0; degrees <= 105.0; degrees += 0.5) {
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 15.0) {
      const double theta = degrees * std::numbers::pi / 180.0;
      const double phi = azimuth * std::numbers::pi / 180.0;
      const Ray ray = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
      const std::optional<Pixel> pixel = project(model, ray);
      ASSERT_TRUE(pixel) << degrees;
      EXPECT_LE(distance(*pixel, kannala_brandt(model, ray)), 1e-9) << degrees;
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace fca::test
