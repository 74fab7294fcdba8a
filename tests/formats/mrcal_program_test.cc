// SPDX-License-Identifier: BSD-3-Clause
// The real mrcal, where Debian's python3 has it (python3-mrcal; 2.2): it loads what fca-io writes and what it read, and
// mrcal.project finds our pixels.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <iomanip>
#include <memory>

namespace fca::test {
namespace {

constexpr const char* kPython = "/usr/bin/python3";  // Debian's modules are of no other

/// What a program prints; its warnings are not asked for.
std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), &::pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe != nullptr && std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr) text += part.data();
  return text;
}

bool is_there() {
  return output_of(std::string(kPython) + " -c 'import mrcal; print(\"mrcal\")' 2>/dev/null").ends_with("mrcal\n");
}

/// A file for mrcal, and the camera that we take it for.
struct Case {
  std::string name;
  std::string bytes;
  Rig rig;  ///< Of that camera, with its pose in the reference, where that is specified.
};

std::vector<Ray> rays() {
  std::vector<Ray> grid;
  for (double x = -0.8; x < 0.81; x += 0.2) {
    for (double y = -0.6; y < 0.61; y += 0.15) grid.push_back({x, y, 1.0});
  }
  return grid;
}

/// A folder that is gone in the end.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "fca-mrcal-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

constexpr const char* kScript = R"(
import mrcal, sys, numpy as np
rays = np.loadtxt(sys.argv[1] + '/rays.txt')
for i in range(int(sys.argv[2])):
    try:
        m = mrcal.cameramodel(sys.argv[1] + '/%d.cameramodel' % i)
        numbers = [*m.imagersize(), *m.extrinsics_Rt_fromref().ravel(), *mrcal.project(rays, *m.intrinsics()).ravel()]
        print('loads', *('%.17g' % x for x in numbers))
    except Exception as e:
        print('stops', str(e).replace('\n', ' '))
)";

/// What mrcal says to each: a line of numbers, or why it stops.
std::vector<std::string> said_to(const std::vector<Case>& cases) {
  const Folder folder;
  std::ostringstream text;
  text << std::setprecision(17);
  for (const Ray& ray : rays()) text << ray[0] << " " << ray[1] << " " << ray[2] << "\n";
  folder.write("rays.txt", text.str());
  folder.write("script.py", kScript);
  for (std::size_t i = 0; i < cases.size(); ++i) folder.write(std::to_string(i) + ".cameramodel", cases[i].bytes);
  const std::string output = output_of(std::string(kPython) + " " + folder.path() + "/script.py " + folder.path() + " " +
                                       std::to_string(cases.size()) + " 2>/dev/null");
  return split(output, '\n');
}

/// Size, pose and pixels as we have them.
void expect_ours(const Case& each, const std::string& said) {
  std::istringstream words(said);
  std::string verdict;
  words >> verdict;
  ASSERT_EQ(verdict, "loads") << said << "\n" << each.bytes;
  const Camera& camera = each.rig.cameras.front();
  ImageSize size;
  words >> size.width >> size.height;
  EXPECT_EQ(camera.image_size, size);
  const std::optional<Transform> T = each.rig.resolve(camera.name, "ref");
  for (int i = 0; i < 12; ++i) {  // rows of R, then t
    double number = 0.0;
    words >> number;
    if (T) {
      EXPECT_NEAR(i < 9 ? (*T)(i / 3, i % 3) : (*T)(i - 9, 3), number, 1e-12 * std::max(1.0, std::abs(number)));
    }
  }
  int compared = 0;
  for (const Ray& ray : rays()) {
    Pixel pixel{};
    words >> pixel[0] >> pixel[1];
    const std::optional<Pixel> ours = project(camera.model, ray);
    if (!ours) continue;  // beyond where the lens folds back
    ++compared;
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR((*ours)[i], pixel.at(i), 1e-9 * std::max(1.0, std::abs(pixel.at(i)))) << ray[0] << " " << ray[1];
  }
  EXPECT_GT(compared, 10);
}

void add_fresh(const std::string& name, const Rig& rig, std::vector<Case>& cases) {
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(*find_format("mrcal"), nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(written) << name << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  for (const Written::File& file : written->files) {
    Rig of_file = rig;
    std::erase_if(of_file.cameras, [&file](const Camera& camera) { return camera.name != file.cameras.front(); });
    // The first camera is the reference.
    if (rig.resolve("ref", rig.cameras.front().name) == std::nullopt)
      of_file.poses.push_back({rig.cameras.front().name, "ref", Transform{}});
    cases.push_back({name + " " + file.document.source().name, file.document.bytes(), of_file});
  }
}

/// A camera of a model that mrcal has.
CameraModel opencv_model(const std::string& id, int camera = 0) {
  if (id == "pinhole" || id == "radtan") return sample_model(id, camera);
  CameraModel model = *make_model(id);
  const CameraModel all = sample_model("opencv14", camera);
  for (const Parameter& each : model_info(model).parameters) {
    const ParameterId name(each);
    const bool is_tilt = name == ParameterId("tau_x") || name == ParameterId("tau_y");
    if (is_tilt) continue;
    EXPECT_TRUE(set_parameter(model, name, parameter(all, name).value()));
  }
  return model;
}

Rig opencv_rig(const std::string& id, bool two) {
  Rig rig = sample_rig("radtan", {two, false});
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) rig.cameras[i].model = opencv_model(id, static_cast<int>(i));
  return rig;
}

TEST(MrcalProgram, SeesOurPixelsAndPoses) {
  if (!is_there()) GTEST_SKIP() << "no mrcal for " << kPython;
  std::vector<Case> cases;
  for (const char* model : {"pinhole", "radtan", "rational", "opencv14"}) {
    for (const bool two : {false, true}) {
      add_fresh(model, opencv_rig(model, two), cases);
    }
  }
  Rig odd = sample_rig("radtan", {true, false});
  odd.cameras[0].name = "it's \xC3\xA4 {left}";
  odd.poses[0].b = odd.cameras[0].name;
  set_parameter(odd.cameras[0].model, "k3", 1.25e-12);
  set_parameter(odd.cameras[1].model, "fx", 123456.789);
  set_parameter(odd.cameras[1].model, "cx", -1e-7);
  odd.cameras[1].image_size = ImageSize{20000, 1};
  odd.poses[0].T_a_b(0, 3) = 1e5;
  add_fresh("odd", odd, cases);
  Rig small = opencv_rig("rational", false);
  set_parameter(small.cameras[0].model, "fx", 0.015625);
  set_parameter(small.cameras[0].model, "fy", 1e-3);
  add_fresh("small", small, cases);
  std::vector<fs::path> files = files_in(testdata_dir() / "mrcal" / "good");
  const std::vector<fs::path> corpus = corpus_files_of("mrcal");
  files.insert(files.end(), corpus.begin(), corpus.end());
  for (const fs::path& path : files) {
    const std::string bytes = read_file(path);
    if (bytes.find("LENSMODEL_SPLINED") != std::string::npos) continue;
    const Rig rig = calibration_of(bytes, path.filename().string()).rig;
    cases.push_back({path.filename().string(), bytes, rig});
    add_fresh(path.filename().string(), rig, cases);
  }
  const std::vector<std::string> said = said_to(cases);
  ASSERT_GE(said.size(), cases.size()) << (said.empty() ? "" : said.front());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(cases[i].name);
    expect_ours(cases[i], said[i]);
  }
}

// Our consumer stops where mrcal does, and not elsewhere. It is of the newest version, too, which refuses more.
TEST(MrcalProgram, RefusesWhatOurConsumerRefuses) {
  if (!is_there()) GTEST_SKIP() << "no mrcal for " << kPython;
  std::vector<Case> cases;
  for (const fs::path& path : files_in(testdata_dir() / "mrcal" / "bad", ".cameramodel"))
    cases.push_back({path.filename().string(), read_file(path), {}});
  const std::string bytes = read_file(testdata_dir() / "mrcal" / "good" / "camera-1.cameramodel");
  for (const char* root :
       {"%s", "  %s", "# c\n%s", "# c\n  %s", "\n%s", "\n\n %s", "\xEF\xBB\xBF%s", "(%s)", "%s,", "%s;", "%s%s"}) {
    std::string text = root;
    for (std::size_t at = 0; (at = text.find("%s")) != std::string::npos;)
      text.replace(at, 2, bytes.substr(bytes.find('{'), bytes.rfind('}') + 1 - bytes.find('{')));
    cases.push_back({root, text, {}});
  }
  for (const char* number :
       {"+1", "-1",   "--1", "1_0", "_1",   "1__0", "0x1F", "0b101", "0o17", "017", "00",   "1e400",       "1.",
        ".5", "1.e5", "1e",  "1L",  "True", "None", "nan",  "'1'",   "1 2",  "(1)", "(1,)", "1if 1 else 2"})
    cases.push_back({number, with_replaced(bytes, "815.5", number), {}});
  for (const char* text :
       {"u'LENSMODEL_OPENCV5'", "r'LENSMODEL_OPENCV5'", "ur'LENSMODEL_OPENCV5'", "b'LENSMODEL_OPENCV5'",
        "'LENSMODEL_' 'OPENCV5'", "'LENSMODEL_' b'OPENCV5'", "'''LENSMODEL_OPENCV5'''", "'LENSMODEL\\x5fOPENCV5'",
        "'LENSMODEL\\x5'", "'LENSMODEL_\\\nOPENCV5'", "'LENSMODEL_\nOPENCV5'", "f'LENSMODEL_OPENCV5'", "('LENSMODEL_OPENCV5')"})
    cases.push_back({text, with_replaced(bytes, "'LENSMODEL_OPENCV5'", text), {}});
  const std::vector<std::string> said = said_to(cases);
  ASSERT_GE(said.size(), cases.size()) << (said.empty() ? "" : said.front());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(cases[i].name + ": " + said[i]);
    const consumers::ConsumerView view = consumers::find_consumer("mrcal")->load(cases[i].bytes, {});
    // 2.5 refuses what differs, 2.2 what has rt_cam_ref alone; and what our consumer does not know it does not count.
    if (cases[i].name == "poses-differ.cameramodel" || cases[i].name == "only-rt_cam_ref.cameramodel") continue;
    if (!view.warnings.empty() && view.warnings.front().facts.code == Code::kMrcalSaysOtherLens) continue;
    EXPECT_EQ(view.loads(), said[i].starts_with("loads"));
  }
}

}  // namespace
}  // namespace fca::test
