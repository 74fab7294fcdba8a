// SPDX-License-Identifier: BSD-3-Clause
// Lenses of mrcal that no model here is: their tables of rays are what formulas written here, and the real mrcal where Debian's
// python3 has it, say.
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/calibration.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iomanip>
#include <memory>
#include <sstream>

namespace fca::test {
namespace {

/// A file of that lens with these numbers.
std::string file_of(const std::string& lens, const std::vector<double>& numbers) {
  std::ostringstream text;
  text << std::setprecision(17) << "{\n    'lensmodel':  '" << lens << "',\n    'intrinsics': [ ";
  for (const double number : numbers) text << number << ",";
  text << "],\n    'extrinsics': [ 0., 0., 0., 0., 0., 0.,],\n    'imagersize': [ 1000, 800,],\n}\n";
  return text.str();
}

/// fx fy cx cy, and knots by their column and row.
std::vector<double> splined(int columns, int rows, const std::function<Pixel(int column, int row)>& knot) {
  std::vector<double> numbers = {400.0, 410.0, 502.0, 397.0};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      for (const double each : knot(column, row)) numbers.push_back(each);
    }
  }
  return numbers;
}

Camera read_camera(const std::string& bytes, const std::string& name = "lens.cameramodel") {
  Parsed parsed = parse(bytes, name);
  const std::optional<Calibration> calibration =
      parsed.document ? read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics) : std::nullopt;
  EXPECT_TRUE(calibration) << name;
  return calibration ? calibration->rig.cameras.front() : Camera();
}

using Formula = std::function<Pixel(const Ray& ray)>;

void expect_pixels(const Camera& camera, const Formula& formula) {
  EXPECT_GE(camera.rays.size(), 500U);
  for (const Correspondence& entry : camera.rays) {
    const Pixel pixel = formula(entry.ray);
    ASSERT_NEAR(entry.pixel[0], pixel[0], 1e-9);
    ASSERT_NEAR(entry.pixel[1], pixel[1], 1e-9);
  }
}

Pixel stereographic(const Ray& ray) { return {2.0 * ray[0] / (1.0 + ray[2]), 2.0 * ray[1] / (1.0 + ray[2])}; }

// B-splines whose knots lie on a plane are that plane.
TEST(MrcalOwnLens, SplinesOfPlaneKnotsAreThePlane) {
  for (const int order : {2, 3}) {
    constexpr int kColumns = 12;
    constexpr int kRows = 9;
    const std::string lens = "LENSMODEL_SPLINED_STEREOGRAPHIC_order=" + std::to_string(order) + "_Nx=12_Ny=9_fov_x_deg=140";
    const auto plane = [](double column, double row) {
      return Pixel{0.01 + 0.002 * column - 0.001 * row, -0.02 + 0.001 * column + 0.003 * row};
    };
    const Camera camera = read_camera(file_of(lens, splined(kColumns, kRows, plane)));
    const double edge = 2.0 * std::tan(35.0 * std::acos(-1.0) / 180.0);
    const double per_unit = (kColumns - order) / (2.0 * edge);
    expect_pixels(camera, [&](const Ray& ray) {
      const Pixel u = stereographic(ray);
      const Pixel moved = plane(u[0] * per_unit + (kColumns - 1) / 2.0, u[1] * per_unit + (kRows - 1) / 2.0);
      return Pixel{400.0 * (u[0] + moved[0]) + 502.0, 410.0 * (u[1] + moved[1]) + 397.0};
    });
  }
}

struct Lens {
  std::string name;
  std::vector<double> numbers;
};

std::vector<Lens> lenses() {
  const auto waves = [](int column, int row) {
    return Pixel{0.02 * std::sin(column + 2.0 * row), 0.015 * std::cos(2.0 * column - row)};
  };
  return {{"LENSMODEL_STEREOGRAPHIC", {400.0, 410.0, 502.0, 397.0}},
          {"LENSMODEL_LONLAT", {400.0, 410.0, 502.0, 397.0}},
          {"LENSMODEL_LATLON", {400.0, 410.0, 502.0, 397.0}},
          {"LENSMODEL_CAHVOR", {600.0, 605.0, 502.0, 397.0, 0.01, -0.02, 0.003, 0.04, -0.01}},
          {"LENSMODEL_SPLINED_STEREOGRAPHIC_order=3_Nx=12_Ny=9_fov_x_deg=140", splined(12, 9, waves)},
          {"LENSMODEL_SPLINED_STEREOGRAPHIC_order=2_Nx=13_Ny=10_fov_x_deg=150", splined(13, 10, waves)}};
}

TEST(MrcalOwnLens, IsConvertedAndWrittenAsAnotherOne) {
  for (const Lens& lens : lenses()) {
    const Camera camera = read_camera(file_of(lens.name, lens.numbers));
    EXPECT_GE(camera.rays.size(), 500U) << lens.name;
    EXPECT_EQ(camera.image_size, (ImageSize{1000, 800}));
  }
}

TEST(MrcalOwnLens, WantsAllOfItsNumbers) {
  Parsed parsed = parse(file_of("LENSMODEL_CAHVOR", {600.0, 605.0, 502.0, 397.0, 0.01}), "lens.cameramodel");
  ASSERT_TRUE(parsed.document);
  EXPECT_FALSE(read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics));
  EXPECT_EQ(parsed.diagnostics.entries().front().facts.code, Code::kNumbersWanted);
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen((command + " 2>&1").c_str(), "r"), &::pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe != nullptr && std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr) text += part.data();
  return text;
}

/// The largest distance between the table's pixels and those of the real mrcal; nothing where it does not run.
std::optional<double> distance_to_mrcal(const std::string& file, const Camera& camera) {
  const fs::path rays = fs::temp_directory_path() / ("fca-own-lens-" + std::to_string(::getpid()) + ".txt");
  {
    std::ofstream stream(rays);
    stream << std::setprecision(17);
    for (const Correspondence& entry : camera.rays) {
      for (const double number : entry.ray) stream << number << " ";
      stream << entry.pixel[0] << " " << entry.pixel[1] << "\n";
    }
  }
  const std::string script =
      "import mrcal, numpy as np; t = np.loadtxt('" + rays.string() + "'); m = mrcal.cameramodel('" + file +
      "'); print('distance', np.abs(mrcal.project(np.ascontiguousarray(t[:, :3]), *m.intrinsics()) - t[:, 3:]).max())";
  const std::string said = output_of("/usr/bin/python3 -c \"" + script + "\"");
  fs::remove(rays);
  if (!said.starts_with("distance ")) return std::nullopt;
  return std::stod(said.substr(9));
}

TEST(MrcalOwnLens, PixelsAreThoseOfTheRealProgram) {
  if (!output_of("/usr/bin/python3 -c 'import mrcal'").empty()) GTEST_SKIP() << "no Debian package python3-mrcal";
  const fs::path file = fs::temp_directory_path() / ("fca-own-lens-" + std::to_string(::getpid()) + ".cameramodel");
  for (const Lens& lens : lenses()) {
    std::ofstream(file) << file_of(lens.name, lens.numbers);
    const std::optional<double> distance = distance_to_mrcal(file.string(), read_camera(read_file(file)));
    ASSERT_TRUE(distance) << lens.name;
    EXPECT_LE(*distance, 1e-8) << lens.name;
  }
  fs::remove(file);
  int compared = 0;
  const fs::path corpus = fs::path(FCA_SHARED_DIR) / "corpus/extra/mrcal";
  for (const fs::path& path : fs::exists(corpus) ? files_in(corpus) : std::vector<fs::path>()) {
    if (read_file(path).find("LENSMODEL_SPLINED") == std::string::npos) continue;
    const std::optional<double> distance = distance_to_mrcal(path.string(), read_camera(read_file(path), path.string()));
    ASSERT_TRUE(distance) << path;
    EXPECT_LE(*distance, 1e-7) << path;
    ++compared;
  }
  if (fs::exists(corpus)) {
    EXPECT_GE(compared, 4);
  }
}

}  // namespace
}  // namespace fca::test
