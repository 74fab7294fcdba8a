// SPDX-License-Identifier: BSD-3-Clause
// The real COLMAP, where it is on the PATH (Debian's is 3.8): it loads what fca-io writes, and its bundle adjustment, before
// any step, finds our pixels without an error.
#include "formats/rigs.h"
#include "formats/test_files.h"

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

  void write(const std::string& name, const std::string& bytes) const { std::ofstream(path_ / "in" / name) << bytes; }
  [[nodiscard]] std::string words() const {
    return " --input_path " + (path_ / "in").string() + " --output_path " + (path_ / "out").string() + " ";
  }
  [[nodiscard]] fs::path out() const { return path_ / "out"; }

 private:
  fs::path path_;
};

/// Two images of the first camera from one place, and what our model sees of points in front of it, `shift` pixels beside.
void write_images(const Folder& folder, const Camera& camera, int id, double shift) {
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

std::string fresh(const Rig& rig) {
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(*find_format("colmap"), nullptr, rig, {}, diagnostics);
  EXPECT_TRUE(written);
  return written ? written->files.front().document.bytes() : "";
}

TEST(ColmapProgram, SeesOurPixels) {
  if (!is_there()) GTEST_SKIP() << "no colmap on the PATH";
  for (const fs::path& path : files_in(testdata_dir() / "colmap" / "good")) {
    if (path.extension() != ".txt") continue;
    const std::string bytes = read_file(path);
    // 3.8 knows neither.
    if (bytes.find("EUCM") != std::string::npos || path.stem() == "equidistant") continue;
    const Rig rig = calibration_of(bytes, path.filename().string()).rig;
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
      SCOPED_TRACE(path.filename().string() + " " + rig.cameras[i].name);
      const ExtraField* had = rig.find_extra_field(rig.cameras[i].name, "CAMERA_ID");
      const int id = had != nullptr ? std::stoi(had->value) : static_cast<int>(i) + 1;
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
