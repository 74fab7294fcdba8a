// SPDX-License-Identifier: BSD-3-Clause
// Every format into every other, by the program as users run it, checked by what shares nothing with it: the readers and
// formulas of this folder, each written after the target's own program. For pixels over the whole image of the source: their
// rays by the formula of the source's file, those rays' pixels by the formula of the written bytes; the difference must be
// within the error that `convert --json` reports. A conversion that is exact must agree to 1e-6 px.
#include "formats/corpus_folders.h"
#include "formats/matrix/geometry.h"
#include "formats/matrix/ray_search.h"

#include "cli/run_program.h"

#include <fca/formats/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <map>
#include <set>

#include <rapidjson/document.h>

namespace fca::matrix {

namespace {

using test::RunResult;
using test::TemporaryFolder;
namespace fs = std::filesystem;

constexpr double kExact = 1e-6;         ///< px, where nothing is fitted
constexpr double kSlack = 1.02;         ///< The reported maximum is polished, not proven.
constexpr double kInverseFit = 1e-6;    ///< px that OCamCalib's inverse polynomial may add (issue 3)
constexpr double kPose = 1e-6;          ///< of any element
constexpr double kComparedShare = 0.9;  ///< of what the report scores

/// One calibration: a file, or several that are one rig.
struct Source {
  std::string format;
  std::vector<fs::path> paths;
  std::optional<Size> size = std::nullopt;  ///< For files that specify none.

  [[nodiscard]] std::string name() const { return paths.front().filename().string(); }
  /// What the program is told to read it.
  [[nodiscard]] std::vector<std::string> words() const {
    std::vector<std::string> result;
    for (const fs::path& path : paths) result.push_back(path.string());
    result.insert(result.end(), {"--from", format});
    if (paths.size() > 1) result.emplace_back("--join");
    if (size) result.insert(result.end(), {"--size", std::to_string(size->width) + "x" + std::to_string(size->height)});
    return result;
  }
};

/// A pixel of the source with its ray; `area`: its share of the image, 0 on the border.
struct Sample {
  Pixel pixel{};
  Ray ray{};
  double area = 0.0;
};

/// The source by its own formula.
struct SourceView {
  std::vector<std::vector<Sample>> cameras;
  std::vector<Pose> relative_poses;
};

/// Midpoints of a grid, which carry the area, and the image's border.
std::vector<Sample> samples_of(const PixelFormula& source, const Size& size) {
  constexpr int kGrid = 32;
  constexpr int kBorder = 24;
  std::vector<Sample> all;
  const double right = size.width - 1.0;
  const double bottom = size.height - 1.0;
  for (int row = 0; row < kGrid; ++row) {
    for (int column = 0; column < kGrid; ++column) {
      all.push_back({{(column + 0.5) / kGrid * right, (row + 0.5) / kGrid * bottom}, {}, 1.0 / (kGrid * kGrid)});
    }
  }
  for (int i = 0; i <= kBorder; ++i) {
    const double t = static_cast<double>(i) / kBorder;
    for (const Pixel& pixel :
         {Pixel{t * right, 0.0}, Pixel{t * right, bottom}, Pixel{0.0, t * bottom}, Pixel{right, t * bottom}}) {
      all.push_back({pixel, {}, 0.0});
    }
  }
  std::vector<Sample> result;
  for (Sample& sample : all) {
    const std::optional<Ray> ray = source.ray ? source.ray(sample.pixel) : search_ray(source.pixel, sample.pixel);
    if (!ray) continue;
    sample.ray = *ray;
    result.push_back(sample);
  }
  return result;
}

SourceView view_of(const Source& source) {
  SourceView view;
  const FormatReader& reader = *find_reader(source.format);
  std::vector<std::string> files;
  for (const fs::path& path : source.paths) {
    files.push_back(test::read_file(path));
    for (std::size_t i = 0;; ++i) {
      const std::optional<PixelFormula> formula = reader.camera(files.back(), i);
      if (!formula) break;
      const std::optional<Size> size = formula->size ? formula->size : source.size;
      if (!size) break;
      view.cameras.push_back(samples_of(*formula, *size));
    }
  }
  view.relative_poses = reader.relative_poses(files);
  return view;
}

struct Comparison {
  double worst = 0.0;
  Pixel at{};
  double share = 0.0;  ///< of the image, compared
  std::size_t points = 0;
};

/// Rays within `max_angle`. A ray beyond a fold of the target's formula is no ray of the target: it is not compared, and so
/// missing in the share.
Comparison compare(const std::vector<Sample>& samples, const RayToPixel& target, double max_angle, double allowed) {
  Comparison result;
  for (const Sample& sample : samples) {
    if (angle_of(sample.ray) > max_angle) continue;
    const std::optional<Pixel> pixel = target(sample.ray);
    if (!pixel || !std::isfinite((*pixel)[0]) || !std::isfinite((*pixel)[1])) continue;
    const double off = std::hypot((*pixel)[0] - sample.pixel[0], (*pixel)[1] - sample.pixel[1]);
    if (off > allowed && !reaches(target, sample.ray)) continue;
    result.share += sample.area;
    ++result.points;
    if (off > result.worst) {
      result.worst = off;
      result.at = sample.pixel;
    }
  }
  return result;
}

/// What convert says of one camera.
struct Reported {
  std::string name;
  bool exact = false;
  double max_error = 0.0;
  double max_angle = M_PI;
  double scored = 0.0;
};

struct Converted {
  RunResult run;
  /// px by which the program says that OCamCalib's inverse polynomial is off, where it says that none comes nearer
  double inverse_off = 0.0;
  std::vector<Reported> cameras;
  struct Output {
    std::string bytes;
    std::vector<std::string> cameras;
  };
  std::vector<Output> outputs;
  std::vector<std::string> losses;
  std::size_t cameras_lost = 0;  ///< That the program says it drops.

  [[nodiscard]] bool says_pose_is_lost() const {
    return std::ranges::any_of(losses, [](const std::string& what) {
      return what.find("pose of cam1") != std::string::npos || what.starts_with("T_");
    });
  }
};

/// A number two levels down; nothing where it or its owner is null.
std::optional<double> number_in(const rapidjson::Value& camera, const char* owner, const char* key) {
  if (!camera.HasMember(owner) || !camera[owner].IsObject() || !camera[owner].HasMember(key)) return std::nullopt;
  const rapidjson::Value& value = camera[owner][key];
  return value.IsNumber() ? std::optional(value.GetDouble()) : std::nullopt;
}

/// `output`: within the folder; empty: the folder itself.
Converted convert(const Source& source, const std::string& target, const std::vector<std::string>& options = {},
                  const std::string& output = {}) {
  Converted result;
  const TemporaryFolder folder;
  std::vector<std::string> words = source.words();
  // What a poor model costs is measured here, whatever the verdict on it.
  words.insert(words.begin(), {"convert", "--accept", "pixels-off", "--accept", "no-right-rays", "--accept", "program-refuses",
                               "--accept", "pose-missing", "--accept", "needs-program"});
  words.insert(words.end(), {"--to", target, "-o", folder.path().string() + "/" + output, "--json"});
  words.insert(words.end(), options.begin(), options.end());
  result.run = test::run_program(words);
  rapidjson::Document json;
  json.Parse<rapidjson::kParseFullPrecisionFlag>(result.run.out.c_str(), result.run.out.size());
  if (json.HasParseError() || !json.IsObject() || !json.HasMember("cameras") || !json.HasMember("outputs")) return result;
  for (const rapidjson::Value& camera : json["cameras"].GetArray()) {
    Reported reported;
    reported.name = camera["name"].GetString();
    reported.exact = camera["exact"].GetBool();
    reported.max_error = number_in(camera, "error_px", "max").value_or(0.0);
    // A model that cannot reach the whole lens is fitted and scored inside a cone.
    if (const std::optional<double> angle = number_in(camera, "domain", "scored_to_deg")) {
      reported.max_angle = *angle / 180.0 * M_PI + 1e-9;
    }
    reported.scored = number_in(camera, "domain", "scored_share").value_or(-1.0);
    result.cameras.push_back(reported);
  }
  for (const rapidjson::Value& written : json["outputs"].GetArray()) {
    Converted::Output file;
    file.bytes = test::read_file(written["path"].GetString());
    for (const rapidjson::Value& name : written["cameras"].GetArray()) file.cameras.emplace_back(name.GetString());
    result.outputs.push_back(std::move(file));
  }
  bool inexact = false;
  for (const rapidjson::Value& said : json["diagnostics"].GetArray()) {
    const std::string code = said["code"].GetString();
    inexact = inexact || code == "inverse-inexact";
  }
  for (const rapidjson::Value& loss : json["losses"].GetArray()) {
    result.losses.emplace_back(loss["what"].GetString());
    if (std::string(loss["code"].GetString()) == "camera-dropped") ++result.cameras_lost;
  }
  for (const rapidjson::Value& proof : json["proof"].GetArray()) {
    if (inexact) result.inverse_off = std::max(result.inverse_off, proof["max_diff_px"].GetDouble());
  }
  return result;
}

/// The written camera of that name, by the target's reader.
std::optional<PixelFormula> written_camera(const Converted& converted, const FormatReader& reader, const std::string& name) {
  for (const Converted::Output& output : converted.outputs) {
    const auto place = std::ranges::find(output.cameras, name);
    if (place == output.cameras.end()) continue;
    if (std::optional<PixelFormula> formula =
            reader.camera(output.bytes, static_cast<std::size_t>(place - output.cameras.begin()))) {
      return formula;
    }
  }
  return std::nullopt;
}

double difference(const Pose& a, const Pose& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < 12; ++i) worst = std::max(worst, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
  return worst;
}

/// What is printed of a pair: the worst over its files and cameras.
struct Cell {
  double worst = 0.0;
  double reported = 0.0;
  double share = 1.0;  ///< compared / scored
  int cameras = 0;
  int poses = 0;
  int failed = 0;
};

/// The errors among what a run said.
std::string errors_of(const std::string& out) {
  rapidjson::Document json;
  json.Parse(out.c_str(), out.size());
  if (json.HasParseError() || !json.IsObject() || !json.HasMember("diagnostics")) return out;
  std::string result;
  for (const rapidjson::Value& said : json["diagnostics"].GetArray()) {
    if (std::string(said["severity"].GetString()) == "error") result += std::string(said["message"].GetString()) + "\n";
  }
  return result;
}

using Table = std::map<std::pair<std::string, std::string>, Cell>;

void print(const Table& table) {
  std::vector<std::string> ids;
  for (const Format& format : all_formats()) ids.emplace_back(format.id);
  std::cout << "worst difference / largest reported maximum [px], least compared share of what is scored, cameras + poses\n";
  for (const std::string& from : ids) {
    for (const std::string& to : ids) {
      const auto found = table.find({from, to});
      if (found == table.end()) continue;
      const Cell& cell = found->second;
      std::array<char, 160> line{};
      std::snprintf(line.data(), line.size(), "%10s -> %-10s %9.2e / %9.2e  %5.1f %%  %2d + %d%s", from.c_str(), to.c_str(),
                    cell.worst, cell.reported, 100.0 * cell.share, cell.cameras, cell.poses, cell.failed > 0 ? "  FAILED" : "");
      std::cout << line.data() << "\n";
    }
  }
}

/// Real files of the shared corpus: two of each format, of different models where it has them.
std::vector<Source> corpus_sources(const std::string& format) {
  static const std::multimap<std::string, std::string> files = {
      {"kalibr", "mrastgoo__camera_imu_calibration_kalibr_viper__camchain_yaml__camchain_I0_RPY_4A3_Mei.yaml"},
      {"kalibr", "rpng__open_vins__config__euroc_mav__kalibr_imucam_chain.yaml"},
      {"orbslam3", "thien94__orb_slam3_ros__config__Stereo-Inertial__TUM-VI.yaml"},
      {"orbslam3", "urbste__ORB_SLAM3__Examples__Monocular-Inertial__gopro9_maxlens_fisheye_ds_setting.yaml"},
      {"opencv", "kev1nCh1u__opencv_practice__param__out_camera_data.xml"},
      {"opencv", "rameau-fr__MC-Calib__tests__calibration_gts__synth_Scenario1_calibrated_cameras_data.yml"},
      {"ocamcalib", "matsuren__ocamcalib_undistort__ocamcamera__calib_results_0.txt"},
      {"ocamcalib", "ctu-mrs__uvdar_core__config__uvdar_calibrations__camera_calibrations__calib_results_bf_uv_25001954.txt"},
      {"tumvi", "lukasvst__dm-vio__configs__tumvi_calib__camchain.yaml"},
      {"tumvi", "lukasvst__dm-vio__configs__tumvi_calib__camera02.txt"},
      {"woodscape", "valeoai__WoodScape__scripts__calibration__front.json"},
      {"woodscape", "TonyLeng1314__SynWoodScape-Stitching__FV.json"},
      {"basalt", "VladyslavUsenko__basalt-mirror__data__euroc_ds_calib.json"},
      {"colmap", "sangminkim-99__COLMAP_multicam__colmap_text__cameras.txt"},
      {"colmap", "HexGP__nerf-prep__colmap_text__cameras.txt"},
      {"euroc", "andreruas__scratch_slam__mav0__cam0__sensor.yaml"},
      {"euroc", "andreruas__scratch_slam__mav0__cam1__sensor.yaml"},
      {"kimera", "MIT-SPARK__Kimera-VIO__params__RealSenseIR__LeftCameraParams.yaml"},
      {"kimera", "MIT-SPARK__Kimera-VIO__params__uHumans1__LeftCameraParams.yaml"},
      {"mrcal", "dkogan__mrcal__doc__data__figueroa-overpass-looking-S__opencv8-0.cameramodel"},
      {"mrcal", "dkogan__mrcal__test__data__cam0.opencv8.cameramodel"},
      {"nerfstudio", "sangminkim-99__COLMAP_multicam__transforms.json"},
      {"nerfstudio", "AspasZhang__NeRF__transforms_test.json"},
      {"dso", "lukasvst__dm-vio__configs__euroc__camera.txt"},
      {"dso", "lukasvst__dm-vio__configs__oakd_calib__camera_left.txt"},
      {"stella", "stella-cv__stella_vslam__example__tum_vi__TUM_VI_stereo.yaml"},
      {"stella", "stella-cv__stella_vslam__example__gopro__gopro.yaml"},
      {"fast-livo", "hku-mars__FAST-LIVO2__config__camera_fisheye_HILTI22.yaml"},
      {"fast-livo", "hku-mars__FAST-LIVO2__config__camera_MARS_LVIG.yaml"},
      {"vins", "HKUST-Aerial-Robotics__VINS-Fusion__config__euroc__cam0_mei.yaml"},
      {"ros", "ros-perception__image_common__camera_info_manager__tests__test_calibration__860e9b5.yaml"},
      {"ros", "ethz-asl__rovio__cfg__p22021_equidist.yaml"},
  };
  std::vector<Source> result;
  const std::vector<fs::path> folders = test::corpus_folders(FCA_SHARED_DIR, format);
  const fs::path folder = folders.empty() ? fs::path() : folders.front();
  const auto [first, last] = files.equal_range(format);
  for (auto file = first; file != last; ++file) {
    if (folders.empty()) break;
    EXPECT_TRUE(fs::exists(folder / file->second)) << folder / file->second;
    result.push_back({format, {folder / file->second}});
  }
  const fs::path sizeless = folder / "sourishg__jackal-navigation__src__calibration__stereo_calib_640x400.yaml";
  if (fs::exists(sizeless)) result.push_back({format, {sizeless}, Size{640, 400}});
  if (result.empty()) std::cout << "no corpus of " << format << " in '" << FCA_SHARED_DIR << "'; only our own files\n";
  return result;
}

/// Of our own files those that hold other parts of a calibration.
bool holds_no_camera(const fs::path& path) {
  static const std::set<std::string> kParts = {"imu.yaml", "extrinsics.yml", "config.yaml", "rig-poses-crlf.json",
                                               "imu-result.json"};
  return path.filename().string().find("-rig.json") != std::string::npos || path.stem().string().ends_with("rigs") ||
         kParts.contains(path.filename().string());
}

/// Of our own files that specify no size.
std::optional<Size> size_of_sizeless(const fs::path& path) {
  static const std::map<std::string, Size> sizes = {{"k1d1.yml", {640, 360}},
                                                    {"stereo-14.yml", {640, 480}},
                                                    {"rig-config.json", {640, 480}},
                                                    {"two-rigs.json", {640, 480}},
                                                    {"version-5.json", {1280, 800}}};
  const auto found = sizes.find(path.filename().string());
  return found == sizes.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Source> sources_of(const std::string& format) {
  std::vector<Source> result;
  const fs::path good = fs::path(FCA_TESTDATA_DIR) / "formats" / format / "good";
  if (fs::exists(good)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(good)) {
      if (entry.is_regular_file() && !holds_no_camera(entry.path()))
        result.push_back({format, {entry.path()}, size_of_sizeless(entry.path())});
    }
  }
  std::ranges::sort(result, {}, &Source::paths);
  for (Source& source : corpus_sources(format)) result.push_back(std::move(source));
  return result;
}

/// Whether a pose may be missing that the source has. A wrong one may never be written.
enum class Poses { kKept, kKeptOrSaidLost };

/// Two cameras that look to different sides are no stereo pair.
Poses expected_poses(const Format& to) { return to.pair_poses ? Poses::kKeptOrSaidLost : Poses::kKept; }

class Matrix {
 public:
  /// All targets for one source.
  void run(const Source& source) {
    SCOPED_TRACE(source.name());
    const SourceView view = view_of(source);
    EXPECT_FALSE(view.cameras.empty()) << "a source without a camera compares nothing";
    for (const Format& to : written_formats()) {
      const FormatReader* target = find_reader(std::string(to.id));
      if (target == nullptr) continue;  // a failure of its own
      SCOPED_TRACE(source.format + " -> " + target->id);
      evaluate(source, view, convert(source, target->id), to, *target, expected_poses(to));
    }
  }

  /// A conversion that is done: every camera, and the pose between the first two.
  void evaluate(const Source& source, const SourceView& view, const Converted& converted, const Format& to,
                const FormatReader& target, Poses poses = Poses::kKept) {
    Cell& cell = table_[{source.format, target.id}];
    const int failures_before = failures();
    check(source, view, converted, to, target, poses, cell);
    if (failures() > failures_before) ++cell.failed;
  }

  [[nodiscard]] const Table& table() const { return table_; }

 private:
  static int failures() {
    const ::testing::TestResult& result = *::testing::UnitTest::GetInstance()->current_test_info()->result();
    int count = 0;
    for (int i = 0; i < result.total_part_count(); ++i) count += result.GetTestPartResult(i).failed() ? 1 : 0;
    return count;
  }

  static void check(const Source& source, const SourceView& view, const Converted& converted, const Format& to,
                    const FormatReader& target, Poses poses, Cell& cell) {
    // SVO projects by twelve coefficients of an inverse polynomial, which are not enough for such a lens: it is not written.
    const bool is_cut = source.format == "colmap" && to.id == "ncamera" && source.name() == "aria.txt";
    // No lens is like a panorama: it stays in its file. One file of that name is a pair.
    const bool is_panorama = source.name().find("equirectangular.yaml") != std::string::npos && view.relative_poses.empty();
    const int expected = is_cut ? 1 : is_panorama && to.id != "stella" ? 2 : 0;
    EXPECT_EQ(converted.run.code, expected) << converted.run.err << "\n" << errors_of(converted.run.out);
    if (converted.run.code != 0) return;
    EXPECT_FALSE(converted.cameras.empty());
    EXPECT_LE(converted.cameras.size(), std::min(view.cameras.size(), to.most_cameras));
    EXPECT_EQ(converted.cameras.size() + converted.cameras_lost, view.cameras.size())
        << "a camera is neither written nor said to be lost";
    const std::size_t count = std::min(view.cameras.size(), converted.cameras.size());
    for (std::size_t i = 0; i < count; ++i) {
      check(converted, view.cameras[i], converted.cameras[i], source.format == target.id, target, cell);
    }
    if (count < 2 || !to.extrinsics || view.relative_poses.empty()) return;
    std::vector<std::string> files;
    for (const Converted::Output& output : converted.outputs) files.push_back(output.bytes);
    const std::vector<Pose> written = target.relative_poses(files);
    // More than two mei cameras are OpenCV files of one camera each, without a pose to another, and so are two of two kinds.
    const bool is_of_kinds = source.format == "ncamera" && to.id == "opencv";
    const bool apart = (count > 2 || is_of_kinds) && converted.outputs.size() == count;
    const bool may_be_missing = (poses == Poses::kKeptOrSaidLost || apart) && converted.says_pose_is_lost();
    EXPECT_TRUE(!written.empty() || may_be_missing) << "the source has a pose between its cameras, the target none";
    for (const Pose& pose : written) {
      EXPECT_LE(difference(pose, view.relative_poses.front()), kPose) << "the pose of the first camera in the second";
    }
    if (!written.empty()) ++cell.poses;
  }

  static void check(const Converted& converted, const std::vector<Sample>& samples, const Reported& reported, bool kept,
                    const FormatReader& target, Cell& cell) {
    SCOPED_TRACE(reported.name);
    const std::optional<PixelFormula> formula = written_camera(converted, target, reported.name);
    EXPECT_TRUE(formula) << "the written file has no camera that " << target.id << "'s independent reader understands";
    if (!formula) return;
    const double allowed = (reported.exact ? 0.0 : reported.max_error * kSlack) + kExact;
    Comparison comparison = compare(samples, formula->pixel, reported.max_angle, allowed);
    EXPECT_LE(comparison.worst, allowed) << "at " << comparison.at[0] << " " << comparison.at[1] << ", reported "
                                         << reported.max_error << (reported.exact ? " (exact)" : "");
    // In a file that is kept, the inverse polynomial is what it was.
    if (formula->stored_approximation && !kept) {
      const double with_inverse = allowed + std::max(kInverseFit, converted.inverse_off);
      const Comparison stored = compare(samples, formula->stored_approximation, reported.max_angle, with_inverse);
      EXPECT_LE(stored.worst, with_inverse) << "by the inverse polynomial, at " << stored.at[0] << " " << stored.at[1];
      comparison.worst = std::max(comparison.worst, stored.worst);
    }
    double all = 0.0;
    for (const Sample& sample : samples) all += sample.area;
    const double scored = reported.scored < 0.0 ? all : reported.scored;
    EXPECT_GE(comparison.share, kComparedShare * scored);
    EXPECT_GT(comparison.points, 50U);
    cell.worst = std::max(cell.worst, comparison.worst);
    cell.reported = std::max(cell.reported, reported.max_error);
    cell.share = std::min(cell.share, scored > 0.0 ? comparison.share / scored : 0.0);
    ++cell.cameras;
  }

  Table table_;
};

TEST(Matrix, EveryFormatHasAnIndependentReader) {
  for (const Format& format : all_formats()) {
    if (format.id == "rays") continue;  // a table has no formula
    EXPECT_NE(find_reader(std::string(format.id)), nullptr)
        << "write tests/formats/matrix/pixels_" << format.id << ".cc: what the format's own program reads and computes";
  }
}

// A test per source's format, so that they run next to each other.
class MatrixFrom : public testing::TestWithParam<const Format*> {};

TEST_P(MatrixFrom, EveryTargetReproducesTheSourcesPixels) {
  const std::string id(GetParam()->id);
  if (find_reader(id) == nullptr) GTEST_SKIP() << "told above";
  Matrix matrix;
  const std::vector<Source> sources = sources_of(id);
  EXPECT_FALSE(sources.empty()) << "no file to begin from: " << id;
  for (const Source& source : sources) matrix.run(source);
  for (const Format& to : written_formats()) {
    const auto cell = matrix.table().find({id, std::string(to.id)});
    EXPECT_TRUE(cell != matrix.table().end() && cell->second.cameras > 0) << id << " -> " << to.id << ": nothing was compared";
  }
  print(matrix.table());
}

std::vector<const Format*> formats() {
  std::vector<const Format*> result;
  for (const Format& format : all_formats()) result.push_back(&format);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Formats, MatrixFrom, testing::ValuesIn(formats()),
                         [](const testing::TestParamInfo<const Format*>& format) {
                           std::string name(format.param->id);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

Source own(const std::string& format, const std::string& name) {
  return {format, {fs::path(FCA_TESTDATA_DIR) / "formats" / format / "good" / name}};
}

// Every model that a format stores, the dialects of forks among them: a wide pair and a narrow camera, each fitted by the model
// asked for.
TEST(Matrix, EveryStoredModel) {
  Matrix matrix;
  for (const Source& source : {own("kalibr", "tumvi.yaml"), own("kalibr", "block-style.yaml")}) {
    const SourceView view = view_of(source);
    for (const Format& to : written_formats()) {
      const FormatReader* target = find_reader(std::string(to.id));
      if (target == nullptr) continue;
      for (const StoredModel& stored : to.models) {
        SCOPED_TRACE(source.name() + " -> " + target->id + " " + std::string(stored.model));
        matrix.evaluate(source, view, convert(source, target->id, {"--model", std::string(stored.model)}), to, *target,
                        expected_poses(to));
      }
    }
  }
  print(matrix.table());
}

// Every layout of a format that has several. Not every layout holds every rig; one of these it holds.
TEST(Matrix, EveryLayout) {
  Matrix matrix;
  const std::vector<Source> sources = {own("kalibr", "tumvi.yaml"), own("kalibr", "block-style.yaml"),
                                       own("kalibr", "omni.yaml"), own("kalibr", "eucm.yaml")};
  for (const Format& to : written_formats()) {
    const FormatReader* target = find_reader(std::string(to.id));
    if (target == nullptr) continue;
    for (const std::string_view layout : to.layouts) {
      int held = 0;
      for (const Source& source : sources) {
        SCOPED_TRACE(source.name() + " -> " + target->id + " " + std::string(layout));
        std::vector<std::string> options = {"--" + target->id + "-layout", std::string(layout)};
        if (layout == "slam_no_opt") options.insert(options.end(), {"--model", "eucm"});
        const Converted converted = convert(source, target->id, options);
        if (converted.run.code != 0) continue;
        ++held;
        matrix.evaluate(source, view_of(source), converted, to, *target, Poses::kKeptOrSaidLost);
      }
      EXPECT_GT(held, 0) << target->id << " " << layout;
    }
  }
}

// OpenCV's three syntaxes.
TEST(Matrix, EverySyntaxOfOpenCv) {
  const Format* to = find_format("opencv");
  if (to == nullptr) GTEST_SKIP() << "no format opencv in the registry";
  Matrix matrix;
  for (const Source& source : {own("kalibr", "tumvi.yaml"), own("kalibr", "block-style.yaml"), own("kalibr", "ds.yaml")}) {
    for (const auto& [name, begins] :
         {std::pair("out.xml", "<?xml"), std::pair("out.json", "{"), std::pair("out.yml", "%YAML")}) {
      SCOPED_TRACE(source.name() + " -> " + name);
      const Converted converted = convert(source, "opencv", {}, name);
      matrix.evaluate(source, view_of(source), converted, *to, *find_reader("opencv"));
      ASSERT_FALSE(converted.outputs.empty());
      EXPECT_EQ(converted.outputs.front().bytes.rfind(begins, 0), 0U);
    }
  }
}

/// The four cameras around a car, in files of their own.
Source surround_view(const TemporaryFolder& folder) {
  Source source = {"woodscape", {}};
  const auto add = [&](const std::string& name, const std::string& quaternion, const std::string& translation,
                       const std::string& offset) {
    source.paths.emplace_back(folder.write(
        name + ".json", R"({"extrinsic": {"quaternion": [)" + quaternion + R"(], "translation": [)" + translation +
                            R"(]}, "intrinsic": {"aspect_ratio": 1.001, "cx_offset": )" + offset +
                            R"(, "cy_offset": -3.1, "height": 966.0, "k1": 339.7, "k2": -31.9, "k3": 48.2, "k4": -7.2,
      "model": "radial_poly", "poly_order": 4, "width": 1280.0}, "name": ")" +
                            name + R"("})"));
  };
  add("FV", "0.59, -0.58, 0.39, -0.39", "3.7, 0.0, 0.66", "3.9");
  add("MVL", "0.92, -0.01, 0.02, -0.38", "1.9, 1.0, 0.9", "-1.2");
  add("MVR", "-0.02, 0.91, -0.4, 0.03", "1.9, -1.0, 0.9", "0.7");
  add("RV", "0.6, 0.57, -0.39, -0.4", "-0.6, 0.01, 0.71", "2.2");
  return source;
}

/// Every camera of the rig was compared in every format; but ORB-SLAM3 uses one of them: those around a car look into all
/// directions, and no two are a stereo pair.
void expect_all_cameras(const Matrix& matrix, const Source& source) {
  EXPECT_EQ(matrix.table().size(), written_formats().size());
  for (const auto& [pair, cell] : matrix.table()) {
    const std::size_t most = find_format(pair.second)->most_cameras == SIZE_MAX ? SIZE_MAX : 1;
    EXPECT_EQ(static_cast<std::size_t>(cell.cameras), std::min(source.paths.size(), most)) << pair.second;
  }
}

// Cameras that come in files of their own are one rig with --join: their poses in the vehicle become poses to each other.
TEST(Matrix, JoinedWoodScapeFiles) {
  if (find_format("woodscape") == nullptr) GTEST_SKIP() << "no format woodscape in the registry";
  const TemporaryFolder folder;
  const Source source = surround_view(folder);
  Matrix matrix;
  matrix.run(source);
  expect_all_cameras(matrix, source);
  print(matrix.table());
}

// The published four of SynWoodScape, whose poses stand in another program's frame and are left out.
TEST(Matrix, JoinedWoodScapeFilesOfTheCorpus) {
  const fs::path folder = fs::path(FCA_SHARED_DIR) / "corpus" / "woodscape";
  if (!fs::exists(folder)) GTEST_SKIP() << "no corpus beside the repository: " << folder;
  Source source = {"woodscape", {}};
  for (const char* name : {"FV", "MVL", "MVR", "RV"})
    source.paths.push_back(folder / ("TonyLeng1314__SynWoodScape-Stitching__" + std::string(name) + ".json"));
  Matrix matrix;
  matrix.run(source);
  expect_all_cameras(matrix, source);
  print(matrix.table());
}

/// The numbers of a text, with their places.
struct NumberInText {
  std::size_t offset = 0;
  std::size_t length = 0;
  double value = 0.0;
};

std::vector<NumberInText> numbers_in(const std::string& text) {
  std::vector<NumberInText> result;
  for (std::size_t i = 0; i < text.size();) {
    NumberInText number{i, 0, 0.0};
    const bool starts = (std::isdigit(static_cast<unsigned char>(text[i])) != 0 || text[i] == '-') &&
                        (i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0);
    const auto [end, error] = std::from_chars(text.data() + i, text.data() + text.size(), number.value);
    if (starts && error == std::errc()) {
      number.length = static_cast<std::size_t>(end - (text.data() + i));
      result.push_back(number);
      i += number.length;
    } else {
      ++i;
    }
  }
  return result;
}

// A comparison that cannot fail proves nothing: the centre's column, moved by a hundredth of a pixel (more where the fit is
// worse), must show.
TEST(Matrix, NoticesAMovedCentre) {
  const Source source = own("kalibr", "tumvi.yaml");
  const std::vector<Sample> samples = view_of(source).cameras.front();
  for (const Format& format : written_formats()) {
    const FormatReader* reader = find_reader(std::string(format.id));
    if (reader == nullptr) continue;  // told above
    SCOPED_TRACE(reader->id);
    const Converted converted = convert(source, reader->id);
    ASSERT_FALSE(converted.outputs.empty()) << converted.run.err;
    ASSERT_FALSE(converted.cameras.empty());
    const std::string& written = converted.outputs.front().bytes;
    const std::optional<PixelFormula> formula = reader->camera(written, 0);
    ASSERT_TRUE(formula);
    const Reported& reported = converted.cameras.front();
    const double allowed = (reported.exact ? 0.0 : reported.max_error * kSlack) + kExact;
    EXPECT_LE(compare(samples, formula->pixel, reported.max_angle, allowed).worst, allowed);
    const double centre = (*formula->pixel({0.0, 0.0, 1.0}))[0];
    const double shift = 0.01 + 2.0 * allowed;
    int moved = 0;
    for (const NumberInText& number : numbers_in(written)) {
      // As it is, as an offset from the image's middle (WoodScape), or in pixels that begin at 0.5 (COLMAP).
      const auto is = [&number](double value) { return std::abs(number.value - value) < 1e-9; };
      const bool is_centre = is(centre) || is(centre - 512 / 2 + 0.5) || is(centre + 0.5);
      if (!is_centre) continue;
      ++moved;
      std::array<char, 40> spelled{};
      const int length = std::snprintf(spelled.data(), spelled.size(), "%.17g", number.value + shift);
      std::string changed = written;
      changed.replace(number.offset, number.length, spelled.data(), static_cast<std::size_t>(length));
      const std::optional<PixelFormula> wrong = reader->camera(changed, 0);
      ASSERT_TRUE(wrong);
      EXPECT_GT(compare(samples, wrong->pixel, reported.max_angle, allowed).worst, allowed);
    }
    EXPECT_GT(moved, 0) << "the centre " << centre << " is not in the text";
  }
}

}  // namespace

}  // namespace fca::matrix
