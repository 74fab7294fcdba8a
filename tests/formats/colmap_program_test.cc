// SPDX-License-Identifier: BSD-3-Clause
// The real COLMAP, where it is on the PATH (Debian's is 3.8): it loads what fca-io writes, and its bundle adjustment, before
// any step, finds our pixels without an error.
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "text/binary.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iomanip>
#include <memory>

namespace fca::test {
namespace {

std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen((command + " 2>&1").c_str(), "r"), &::pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe != nullptr && std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr) text += part.data();
  return text;
}

/// No window is ever opened.
std::string colmap(const std::string& words) { return output_of("QT_QPA_PLATFORM=offscreen colmap " + words); }

bool is_there() { return colmap("help").starts_with("COLMAP"); }

/// A folder that is gone in the end.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "fca-colmap-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
    fs::create_directory(path_ / "in");
    fs::create_directory(path_ / "out");
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / "in" / name, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::string words() const {
    return " --input_path " + (path_ / "in").string() + " --output_path " + (path_ / "out").string() + " ";
  }
  [[nodiscard]] fs::path in() const { return path_ / "in"; }
  [[nodiscard]] fs::path out() const { return path_ / "out"; }

 private:
  fs::path path_;
};

/// Two images of the first camera from one place, and what our model sees of points in front of it, `shift` pixels to the side.
void write_images(const Folder& folder, const Camera& camera, unsigned long id, double shift) {
  std::ostringstream seen;
  std::ostringstream points;
  seen << std::setprecision(17);
  points << std::setprecision(17);
  int point = 0;
  for (double x = -0.6; x < 0.61; x += 0.3) {
    for (double y = -0.4; y < 0.41; y += 0.2) {
      const std::optional<Pixel> pixel = project(camera.model, {x, y, 1.0});
      ASSERT_TRUE(pixel);
      seen << (*pixel)[0] + 0.5 + shift << " " << (*pixel)[1] + 0.5 << " " << point + 1 << " ";
      points << point + 1 << " " << x << " " << y << " 1 0 0 0 0 1 " << point << " 2 " << point << "\n";
      ++point;
    }
  }
  std::string images;
  for (const char* image : {"1", "2"})
    images += std::string(image) + " 1 0 0 0 0 0 0 " + std::to_string(id) + " " + image + ".png\n" + seen.str() + "\n";
  folder.write("images.txt", images);
  folder.write("points3D.txt", points.str());
}

/// The root of the mean square of what it sees elsewhere [px], as it prints it; nothing where it stops.
std::optional<double> initial_cost(const Folder& folder) {
  const std::string text = colmap("bundle_adjuster" + folder.words() +
                                  "--BundleAdjustment.max_num_iterations 0 --BundleAdjustment.refine_focal_length 0 "
                                  "--BundleAdjustment.refine_extra_params 0");
  const std::size_t at = text.find("Initial cost :");
  if (at == std::string::npos) return std::nullopt;
  return std::stod(text.substr(at + 14));
}

/// Are all of the file's models among those that COLMAP 3.8 has?
bool is_known_to_3_8(const std::string& bytes) {
  constexpr std::array kModels = {"SIMPLE_PINHOLE",
                                  "PINHOLE",
                                  "SIMPLE_RADIAL",
                                  "RADIAL",
                                  "OPENCV",
                                  "OPENCV_FISHEYE",
                                  "FULL_OPENCV",
                                  "FOV",
                                  "SIMPLE_RADIAL_FISHEYE",
                                  "RADIAL_FISHEYE",
                                  "THIN_PRISM_FISHEYE"};
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string id;
    std::string model;
    if (!(words >> id >> model) || id.starts_with("#")) continue;
    if (std::ranges::find(kModels, model) == kModels.end()) return false;
  }
  return true;
}

std::string fresh(const Rig& rig) {
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(*find_format("colmap"), nullptr, rig, {}, diagnostics);
  EXPECT_TRUE(written);
  return written ? written->files.front().document.bytes() : "";
}

/// The bytes as a file of the other kind, by us.
std::string as(const std::string& bytes, const std::string& name, const std::string& extension) {
  Diagnostics diagnostics;
  const text::Document base = document_of(bytes, name);
  WriteOptions options;
  options.extension = extension;
  const std::optional<Written> written =
      write_calibration(*find_format("colmap"), &base, calibration_of(bytes, name).rig, options, diagnostics);
  EXPECT_TRUE(written);
  return written ? written->files.front().document.bytes() : "";
}

/// The file of cameras into which COLMAP converts one. `kind`: "txt" or "bin", of what goes in.
std::string as_colmap_writes(const std::string& cameras, const std::string& kind, const std::string& to) {
  const Folder folder;
  const std::string none = kind == "bin" ? std::string(8, '\0') : "";
  folder.write("cameras." + kind, cameras);
  folder.write("images." + kind, none);
  folder.write("points3D." + kind, none);
  const std::string said = colmap("model_converter" + folder.words() + "--output_type " + (to == "bin" ? "BIN" : "TXT"));
  const fs::path file = folder.out() / ("cameras." + to);
  EXPECT_TRUE(fs::exists(file)) << said;
  return fs::exists(file) ? read_file(file) : "";
}

/// Of each of the models that 3.8 knows and we read, with all digits.
constexpr std::array kLines = {
    "7 SIMPLE_PINHOLE 640 480 500.1 320.3 240.7",
    "1 PINHOLE 640 480 500.1 501.3 320.3 240.7",
    "2 SIMPLE_RADIAL 640 480 500.1 320.3 240.7 -0.1",
    "3 RADIAL 640 480 500.1 320.3 240.7 -0.1 1e-05",
    "4 OPENCV 640 480 500.1 501.3 320.3 240.7 -0.1 0.02 0.0003 -0.0007",
    "5 OPENCV_FISHEYE 640 480 300.1 301.3 320.3 240.7 0.01 -0.002 0.0003 -7e-05",
    "6 FULL_OPENCV 640 480 500.1 501.3 320.3 240.7 -0.1 0.02 0.0003 -0.0007 0.001 0.03 -0.004 0.0005",
    "8 FOV 640 480 500.1 501.3 320.3 240.7 0.93",
    "9 SIMPLE_RADIAL_FISHEYE 640 480 300.1 320.3 240.7 0.01",
    "10 RADIAL_FISHEYE 640 480 300.1 320.3 240.7 0.01 -0.002",
    "11 THIN_PRISM_FISHEYE 640 480 300.1 301.3 320.3 240.7 0.01 -0.002 0.0003 -0.0007 0.001 -0.0002 0.0005 -0.0001"};

TEST(ColmapProgram, MakesTheSameBytesOfText) {
  if (!is_there()) GTEST_SKIP() << "no colmap on the PATH";
  for (const char* line : kLines) {
    SCOPED_TRACE(line);
    const std::string text = std::string(line) + "\n";
    const std::string binary = as(text, "cameras.txt", ".bin");
    EXPECT_EQ(binary, as_colmap_writes(text, "txt", "bin"));
    // And back: its text of our bytes is its text of ours, and of the first.
    const std::string back = as_colmap_writes(binary, "bin", "txt");
    EXPECT_EQ(back, as_colmap_writes(text, "txt", "txt"));
    EXPECT_EQ(back, as_colmap_writes(as(binary, "cameras.bin", ".txt"), "txt", "txt"));
    EXPECT_EQ(as(back, "cameras.txt", ".bin"), binary);
  }
}

TEST(ColmapProgram, OpensTheFolder) {
  if (!is_there()) GTEST_SKIP() << "no colmap on the PATH";
  Diagnostics diagnostics;
  for (const char* extension : {"", ".bin"}) {
    WriteOptions options;
    options.extension = extension;
    const std::optional<Written> written =
        write_calibration(*find_format("colmap"), nullptr, sample_rig("kb4", {true, false}), options, diagnostics);
    ASSERT_TRUE(written);
    const Folder folder;
    for (const Written::File& file : written->files) folder.write(file.place, file.document.bytes());
    const std::string said = colmap("model_analyzer --path " + folder.in().string());
    EXPECT_NE(said.find("Cameras: 2"), std::string::npos) << said;
  }
}

TEST(ColmapProgram, SeesOurPixels) {
  if (!is_there()) GTEST_SKIP() << "no colmap on the PATH";
  for (const fs::path& path : files_in(testdata_dir() / "colmap" / "good")) {
    if (path.extension() != ".txt" || path.stem().string().ends_with("rigs")) continue;
    const std::string bytes = read_file(path);
    if (!is_known_to_3_8(bytes)) continue;
    const Rig rig = calibration_of(bytes, path.filename().string()).rig;
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
      SCOPED_TRACE(path.filename().string() + " " + rig.cameras[i].name);
      const ExtraField* had = rig.find_extra_field(rig.cameras[i].name, "CAMERA_ID");
      const unsigned long id = had != nullptr ? std::stoul(had->value) : i + 1;
      for (const std::string& file : {bytes, fresh(rig)}) {
        const Folder folder;
        folder.write("cameras.txt", file);
        write_images(folder, rig.cameras[i], id, 0.0);
        const std::optional<double> cost = initial_cost(folder);
        ASSERT_TRUE(cost) << file;
        EXPECT_LT(*cost, 1e-9) << file;
      }
    }
  }
}

// So the test can fail. COLMAP prints sqrt(sum / 2 / n), and one of the two numbers of each point is off.
TEST(ColmapProgram, FindsHalfAPixel) {
  if (!is_there()) GTEST_SKIP() << "no colmap on the PATH";
  const Rig rig = sample_rig("radtan", {false, false});
  const Folder folder;
  folder.write("cameras.txt", fresh(rig));
  write_images(folder, rig.cameras.front(), 1, 0.5);
  const std::optional<double> cost = initial_cost(folder);
  ASSERT_TRUE(cost);
  EXPECT_NEAR(*cost, 0.25, 1e-6);
}

}  // namespace
}  // namespace fca::test
