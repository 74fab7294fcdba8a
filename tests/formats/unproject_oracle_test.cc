// SPDX-License-Identifier: BSD-3-Clause
// The rays that Kalibr and ORB-SLAM3 printed for pixels of real files (oracles/README.md), against fca::unproject on the camera
// our reader gives.
//
// A row counts where the program's ray projects back to its pixel by the program's own formula (formats/consumers), and the
// image radius grows all the way out to it. Excepted, and counted by cause, which is asked of that formula and not of our
// answer:
//   nan        the program itself has no ray;
//   mirrored   the pixel is that of the ray turned round (-x, -y, -z): the program took the tangent of an angle beyond 90
//              degrees;
//   folded     the pixel, or the ray, lies where the image radius has shrunk on the way out to it: one of several rays;
//   unsolved   none of these: the program's inverse ends elsewhere (a fixed number of steps, a capped angle, no lens).
// Rows of a program that rescales its image are compared at the pixel of the file, those of one that misreads its second camera
// (ORB-SLAM3, FORMATS.md 3.2) with that camera; both are counted.
//
// What a counted row allows is not fitted. By the program's formula its ray belongs to a pixel `back` px from u; back is at
// most what separates two right implementations of the formula (oracle_tolerance). Our ray belongs to u. So the pixels of the
// two rays are at most back + that tolerance apart, and so is the angle between them times the pixels per radian, taken in the
// direction in which they are fewest.
#include "formats/oracle_camera.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace fca::test {
namespace {

struct Counts {
  int compared = 0;
  int rescaled = 0;  ///< Of those compared: the program works on an image of another size.
  int nan = 0;
  int mirrored = 0;
  int folded = 0;
  int unsolved = 0;
  int misread = 0;     ///< Of those compared: with the first camera's lens coefficients, as the program takes them.
  double worst = 0.0;  ///< In units of what the row allows.
};

Ray normalised(const Ray& ray) {
  const double length = std::hypot(ray[0], ray[1], ray[2]);
  return {ray[0] / length, ray[1] / length, ray[2] / length};
}

Ray turned(const Ray& ray) { return {-ray[0], -ray[1], -ray[2]}; }

Ray cross(const Ray& a, const Ray& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double angle_between(const Ray& a, const Ray& b) {
  const Ray c = cross(a, b);
  return std::atan2(std::hypot(c[0], c[1], c[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/// How far the pixel moves per radian at the ray, in the direction in which it moves least: the smaller singular value of the
/// 2 x 2 Jacobian over the ray's tangent plane, by central differences.
double fewest_pixels_per_radian(const CameraModel& model, const Ray& at) {
  const Ray ray = normalised(at);
  const Ray aside = normalised(cross(ray, std::abs(ray[0]) < 0.5 ? Ray{1.0, 0.0, 0.0} : Ray{0.0, 1.0, 0.0}));
  const std::array<Ray, 2> tangents = {aside, cross(ray, aside)};
  constexpr double kStep = 1e-6;
  std::array<Pixel, 2> columns{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Ray& t = tangents[i];
    const auto moved = [&](double step) {
      return project(model, {ray[0] + step * t[0], ray[1] + step * t[1], ray[2] + step * t[2]});
    };
    const std::optional<Pixel> forwards = moved(kStep);
    const std::optional<Pixel> back = moved(-kStep);
    if (!forwards || !back) return 0.0;
    columns[i] = {((*forwards)[0] - (*back)[0]) / (2.0 * kStep), ((*forwards)[1] - (*back)[1]) / (2.0 * kStep)};
  }
  const auto& [a, b] = columns;
  const double determinant = std::abs(a[0] * b[1] - a[1] * b[0]);
  const double squares = a[0] * a[0] + a[1] * a[1] + b[0] * b[0] + b[1] * b[1];
  const double largest =
      std::sqrt(0.5 * (squares + std::sqrt(std::max(0.0, squares * squares - 4.0 * determinant * determinant))));
  return largest > 0.0 ? determinant / largest : 0.0;
}

class OracleTables {
 public:
  explicit OracleTables(const std::string& id) : consumer_(*consumers::find_consumer(id)) {}

  /// Rows read, all tables together.
  int compare_all() {
    std::printf("%-100s cam compared  (rescaled, misread)   nan mirrored folded unsolved  worst / allowed\n", "file");
    int rows = 0;
    for (const OracleTable& table : oracle_tables(std::string(consumer_.id), std::string(consumer_.id))) {
      const Counts counts = compare(table);
      std::printf("%-100s %3zu %8d %10d %8d %6d %8d %6d %8d  %.2g\n", table.file.c_str(), table.camera, counts.compared,
                  counts.rescaled, counts.misread, counts.nan, counts.mirrored, counts.folded, counts.unsolved, counts.worst);
      rows += static_cast<int>(table.unprojected.size());
      total_ += counts.compared;
      rescaled_ += counts.rescaled;
      misread_ += counts.misread;
    }
    return rows;
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
    for (const OracleRow& row : table.unprojected) compare_row(row, table, *camera, counts);
    return counts;
  }

  /// Nearly all pixels of a table are those that its "project" rows print. Beyond the fold: no ray before it has that pixel.
  static bool is_beyond_the_fold(const OracleRow& row, double tolerance, const OracleTable& table,
                                 const consumers::ConsumerCamera& theirs) {
    bool printed = false;
    for (const OracleRow& other : table.rows) {
      if (!(distance(other.pixel, row.pixel) <= tolerance)) continue;
      if (!folds_before(theirs, other.ray)) return false;
      printed = true;
    }
    return printed;
  }

  void compare_row(const OracleRow& row, const OracleTable& table, const OracleCamera& camera, Counts& counts) {
    if (!std::isfinite(row.ray[0]) || !std::isfinite(row.ray[1]) || !std::isfinite(row.ray[2])) {
      ++counts.nan;
      return;
    }
    const double tolerance = oracle_tolerance(consumer_, row.pixel);
    const auto miss = [&](const Ray& ray) {
      const auto pixel = camera.theirs.project(ray);
      return pixel ? distance(*pixel, row.pixel) : HUGE_VAL;
    };
    const double back = miss(row.ray);
    if (back > tolerance) {
      if (miss(turned(row.ray)) <= tolerance) {
        ++counts.mirrored;
      } else if (is_beyond_the_fold(row, tolerance, table, camera.theirs)) {
        ++counts.folded;
      } else {
        ++counts.unsolved;
      }
      return;
    }
    if (folds_before(camera.theirs, row.ray)) {
      ++counts.folded;
      return;
    }
    ++counts.compared;
    const std::array<double, 2>& scale = camera.theirs.scale;
    if (camera.is_rescaled()) ++counts.rescaled;
    if (camera.theirs.misread) ++counts.misread;
    const std::optional<Ray> ours = unproject(camera.in_program, {row.pixel[0] / scale[0], row.pixel[1] / scale[1]});
    if (!ours) {
      ADD_FAILURE() << "we have no ray for the pixel " << row.pixel[0] << " " << row.pixel[1];
      return;
    }
    // In pixels of the file; the program's are as many times larger as it scales the image.
    const double allowed = (back + tolerance) / std::min(scale[0], scale[1]);
    const double difference = angle_between(*ours, row.ray) * fewest_pixels_per_radian(camera.in_program, *ours);
    EXPECT_LE(difference, allowed) << "at " << row.pixel[0] << " " << row.pixel[1];
    counts.worst = std::max(counts.worst, difference / allowed);
  }

  const consumers::Consumer& consumer_;
  int total_ = 0;
  int rescaled_ = 0;
  int misread_ = 0;
};

TEST(UnprojectOracle, Kalibr) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  OracleTables tables("kalibr");
  EXPECT_GE(tables.compare_all(), 800);
  EXPECT_GE(tables.total(), 400);
}

TEST(UnprojectOracle, OrbSlam3) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  OracleTables tables("orbslam3");
  EXPECT_GE(tables.compare_all(), 700);
  EXPECT_GE(tables.total(), 300);
  EXPECT_GE(tables.rescaled(), 15) << "EuRoC's image of newWidth x newHeight";
  EXPECT_GE(tables.misread(), 15) << "the second camera of NTU VIRAL";
}

// The proof counts the pixels that ORB-SLAM3 takes for rays from elsewhere, by its own inverse as we wrote it once more: that
// gives the rays that were printed, the wrong ones above all.
TEST(UnprojectOracle, OrbSlam3GoesWrongAsItsConsumerSays) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  const consumers::Consumer& consumer = *consumers::find_consumer("orbslam3");
  int right = 0;
  int wrong = 0;
  double worst = 0.0;
  for (const OracleTable& table : oracle_tables("orbslam3", "orbslam3")) {
    SCOPED_TRACE(table.file);
    const std::optional<OracleCamera> camera = oracle_camera(consumer, table);
    ASSERT_TRUE(camera);
    if (!camera->theirs.unproject) continue;
    for (const OracleRow& row : table.unprojected) {
      const std::optional<Ray> ray = camera->theirs.unproject(row.pixel);
      ASSERT_EQ(ray.has_value(), std::isfinite(row.ray[0]));
      if (!ray) continue;
      constexpr double kOfFloats = 2e-6;  // rad; its Newton steps end at 1e-6
      const double angle = angle_between(*ray, row.ray);
      EXPECT_LE(angle, kOfFloats) << "at " << row.pixel[0] << " " << row.pixel[1];
      worst = std::max(worst, angle);
      const std::optional<Pixel> back = camera->theirs.project(row.ray);
      (back && distance(*back, row.pixel) <= 1.0 ? right : wrong) += 1;
    }
  }
  std::printf("%d rays right and %d wrong, ours off by at most %.2g rad\n", right, wrong, worst);
  EXPECT_GE(right, 100);
  EXPECT_GE(wrong, 10);
}

}  // namespace
}  // namespace fca::test
