// SPDX-License-Identifier: BSD-3-Clause
// Every format into every other, by the program as users run it, judged by what shares nothing with it: the readers and
// formulas of this folder, each written after the target's own program. For pixels over the whole image of the source: their
// rays by the formula of the source's file, those rays' pixels by the formula of the written bytes; the difference must be
// within the error that `convert --json` reports. A conversion that is exact must agree to 1e-6 px.
#include "formats/matrix/geometry.h"
#include "formats/matrix/ray_search.h"

#include "cli/run_program.h"

#include <fca/formats/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <map>

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

struct Source {
  std::string format;
  fs::path path;
  std::vector<std::string> options;  ///< What the program must be told to read it.
};

/// A pixel of the source with its ray; `area`: its share of the image, 0 on the border.
struct Sample {
  Pixel pixel{};
  Ray ray{};
  double area = 0.0;
};

struct SourceCamera {
  std::vector<Sample> samples;
};

/// Midpoints of a grid, which carry the area, and the image's border.
std::vector<Sample> samples_of(const PixelFormula& source) {
  constexpr int kGrid = 32;
  constexpr int kBorder = 24;
  std::vector<Sample> all;
  const double right = source.size->width - 1.0;
  const double bottom = source.size->height - 1.0;
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
  std::vector<Reported> cameras;
  struct Output {
    std::string bytes;
    std::vector<std::string> cameras;
  };
  std::vector<Output> outputs;
};

/// A number two levels down; nothing where it or its owner is null.
std::optional<double> number_in(const rapidjson::Value& camera, const char* owner, const char* key) {
  if (!camera.HasMember(owner) || !camera[owner].IsObject() || !camera[owner].HasMember(key)) return std::nullopt;
  const rapidjson::Value& value = camera[owner][key];
  return value.IsNumber() ? std::optional(value.GetDouble()) : std::nullopt;
}

Converted convert(const Source& source, const std::string& target, const std::vector<std::string>& more = {}) {
  Converted result;
  const TemporaryFolder folder;
  std::vector<std::string> words = {"convert", source.path.string(),         "--from", source.format, "--to", target,
                                    "-o",      folder.path().string() + "/", "--json"};
  words.insert(words.end(), source.options.begin(), source.options.end());
  words.insert(words.end(), more.begin(), more.end());
  result.run = test::run_program(words);
  rapidjson::Document json;
  json.Parse<rapidjson::kParseFullPrecisionFlag>(result.run.out.c_str(), result.run.out.size());
  if (json.HasParseError() || !json.IsObject() || !json.HasMember("cameras") || !json.HasMember("outputs")) return result;
  for (const rapidjson::Value& camera : json["cameras"].GetArray()) {
    Reported reported;
    reported.name = camera["name"].GetString();
    reported.exact = camera["exact"].GetBool();
    reported.max_error = number_in(camera, "error_px", "max").value_or(0.0);
    if (const std::optional<double> angle = number_in(camera, "domain", "max_angle_deg")) {
      reported.max_angle = *angle / 180.0 * M_PI + 1e-9;
    }
    reported.scored = number_in(camera, "domain", "scored_share").value_or(-1.0);
    result.cameras.push_back(reported);
  }
  for (const rapidjson::Value& output : json["outputs"].GetArray()) {
    Converted::Output file;
    file.bytes = test::read_file(output["path"].GetString());
    for (const rapidjson::Value& name : output["cameras"].GetArray()) file.cameras.emplace_back(name.GetString());
    result.outputs.push_back(std::move(file));
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

using Table = std::map<std::pair<std::string, std::string>, Cell>;

void print(const Table& table) {
  std::vector<std::string> ids;
  for (const Format& format : all_formats()) ids.emplace_back(format.id);
  std::cout << "worst difference / largest reported maximum [px], least compared share of what is scored, cameras + poses\n";
  for (const std::string& from : ids) {
    for (const std::string& to : ids) {
      const auto found = table.find({from, to});
      std::array<char, 160> line{};
      if (found == table.end()) {
        std::snprintf(line.data(), line.size(), "%10s -> %-10s nothing compared", from.c_str(), to.c_str());
      } else {
        const Cell& cell = found->second;
        std::snprintf(line.data(), line.size(), "%10s -> %-10s %9.2e / %9.2e  %5.1f %%  %2d + %d%s", from.c_str(), to.c_str(),
                      cell.worst, cell.reported, 100.0 * cell.share, cell.cameras, cell.poses,
                      cell.failed > 0 ? "  FAILED" : "");
      }
      std::cout << line.data() << "\n";
    }
  }
}

/// Real files of the shared corpus: two of each format, of different models where it has them.
std::vector<Source> corpus_sources(const std::string& format) {
  static const std::multimap<std::string, std::string> files = {
      {"kalibr", "mrastgoo__camera_imu_calibration_kalibr_viper__camchain_yaml__camchain_I0_RPY_4A3_Mei.yaml"},
      {"kalibr", "lukasvst__dm-vio__configs__oakd_calib__camchain.yaml"},
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
  };
  std::vector<Source> result;
  const fs::path folder = fs::path(FCA_SHARED_DIR) / "corpus" / format;
  const auto [first, last] = files.equal_range(format);
  for (auto file = first; file != last; ++file) {
    if (fs::exists(folder / file->second)) result.push_back({format, folder / file->second, {}});
  }
  if (result.empty())
    std::cout << "no corpus beside the repository: " << folder << "; only our own files of " << format << "\n";
  return result;
}

std::vector<Source> sources_of(const std::string& format) {
  std::vector<Source> result;
  const fs::path good = fs::path(FCA_TESTDATA_DIR) / "formats" / format / "good";
  if (fs::exists(good)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(good)) {
      if (entry.is_regular_file()) result.push_back({format, entry.path(), {}});
    }
  }
  std::ranges::sort(result, {}, &Source::path);
  for (Source& source : corpus_sources(format)) result.push_back(std::move(source));
  return result;
}

/// How many cameras with an image size the program finds in the file.
std::size_t cameras_by_program(const Source& source) {
  const RunResult run = test::run_program({"show", source.path.string(), "--from", source.format, "--json"});
  rapidjson::Document json;
  json.Parse(run.out.c_str(), run.out.size());
  if (run.code != 0 || json.HasParseError() || !json.HasMember("files")) return 0;
  std::size_t count = 0;
  for (const rapidjson::Value& file : json["files"].GetArray()) {
    if (!file.HasMember("cameras")) continue;
    for (const rapidjson::Value& camera : file["cameras"].GetArray()) {
      const bool sized = camera.HasMember("width_px") && camera["width_px"].IsNumber();
      if (sized) ++count;
    }
  }
  return count;
}

class Matrix {
 public:
  /// All targets for one file.
  void run(const Source& source) {
    SCOPED_TRACE(source.path.filename().string());
    const FormatReader& reader = *find_reader(source.format);
    const std::string bytes = test::read_file(source.path);
    std::vector<SourceCamera> cameras;
    for (std::size_t i = 0;; ++i) {
      const std::optional<PixelFormula> formula = reader.camera(bytes, i);
      if (!formula || !formula->size) break;
      cameras.push_back({samples_of(*formula)});
    }
    if (cameras.empty()) {
      EXPECT_EQ(cameras_by_program(source), 0U) << "the program finds cameras, the independent reader none";
      return;
    }
    const std::vector<Pose> poses = reader.relative_poses({bytes});
    for (const Format& format : all_formats()) {
      const FormatReader* target = find_reader(std::string(format.id));
      if (target != nullptr) run(source, cameras, poses, format, *target);
    }
  }

  [[nodiscard]] const Table& table() const { return table_; }

 private:
  void run(const Source& source, const std::vector<SourceCamera>& cameras, const std::vector<Pose>& poses, const Format& to,
           const FormatReader& target) {
    SCOPED_TRACE(source.format + " -> " + target.id);
    Cell& cell = table_[{source.format, target.id}];
    const bool failed_before = ::testing::Test::HasFailure();
    const Converted converted = convert(source, target.id);
    EXPECT_EQ(converted.run.code, 0) << converted.run.err << converted.run.out.substr(0, 2000);
    if (converted.run.code != 0) {
      ++cell.failed;
      return;
    }
    EXPECT_FALSE(converted.cameras.empty());
    EXPECT_LE(converted.cameras.size(), cameras.size());
    for (std::size_t i = 0; i < std::min(cameras.size(), converted.cameras.size()); ++i) {
      if (!agrees(converted, cameras[i], converted.cameras[i], source, target, cell)) ++cell.failed;
    }
    const std::size_t both = std::min(cameras.size(), converted.cameras.size());
    if (both > 1 && to.extrinsics && !poses.empty()) {
      std::vector<std::string> files;
      for (const Converted::Output& output : converted.outputs) files.push_back(output.bytes);
      const std::vector<Pose> written = target.relative_poses(files);
      EXPECT_FALSE(written.empty()) << "the source has a pose between its cameras, the target none";
      for (const Pose& pose : written) EXPECT_LE(difference(pose, poses.front()), kPose);
      if (!written.empty()) ++cell.poses;
    }
    if (!failed_before && ::testing::Test::HasFailure() && cell.failed == 0) ++cell.failed;
  }

  static bool agrees(const Converted& converted, const SourceCamera& camera, const Reported& reported, const Source& source,
                     const FormatReader& target, Cell& cell) {
    SCOPED_TRACE(reported.name);
    const std::optional<PixelFormula> formula = written_camera(converted, target, reported.name);
    EXPECT_TRUE(formula) << "the written file has no camera that " << target.id << "'s independent reader understands";
    if (!formula) return false;
    const double allowed = (reported.exact ? 0.0 : reported.max_error * kSlack) + kExact;
    Comparison comparison = compare(camera.samples, formula->pixel, reported.max_angle, allowed);
    bool good = comparison.worst <= allowed;
    EXPECT_LE(comparison.worst, allowed) << "at " << comparison.at[0] << " " << comparison.at[1] << ", reported "
                                         << reported.max_error << (reported.exact ? " (exact)" : "");
    // In a file that is kept, the inverse polynomial is what it was.
    if (formula->stored_approximation && source.format != target.id) {
      const Comparison stored =
          compare(camera.samples, formula->stored_approximation, reported.max_angle, allowed + kInverseFit);
      EXPECT_LE(stored.worst, allowed + kInverseFit) << "by the inverse polynomial, at " << stored.at[0] << " " << stored.at[1];
      good = good && stored.worst <= allowed + kInverseFit;
      comparison.worst = std::max(comparison.worst, stored.worst);
    }
    double all = 0.0;
    for (const Sample& sample : camera.samples) all += sample.area;
    const double scored = reported.scored < 0.0 ? all : reported.scored;
    EXPECT_GE(comparison.share, kComparedShare * scored);
    EXPECT_GT(comparison.points, 100U);
    good = good && comparison.share >= kComparedShare * scored && comparison.points > 100;
    cell.worst = std::max(cell.worst, comparison.worst);
    cell.reported = std::max(cell.reported, reported.max_error);
    cell.share = std::min(cell.share, scored > 0.0 ? comparison.share / scored : 0.0);
    ++cell.cameras;
    return good;
  }

  Table table_;
};

TEST(Matrix, EveryFormatHasAnIndependentReader) {
  for (const Format& format : all_formats()) {
    EXPECT_NE(find_reader(std::string(format.id)), nullptr)
        << "write tests/formats/matrix/pixels_" << format.id << ".cc: what the format's own program reads and computes";
  }
}

TEST(Matrix, EveryPairReproducesTheSourcesPixels) {
  Matrix matrix;
  for (const Format& format : all_formats()) {
    const std::string id(format.id);
    if (find_reader(id) == nullptr) continue;  // told above
    const std::vector<Source> sources = sources_of(id);
    EXPECT_FALSE(sources.empty()) << "no file to begin from: " << id;
    for (const Source& source : sources) matrix.run(source);
    for (const Format& to : all_formats()) {
      const auto cell = matrix.table().find({id, std::string(to.id)});
      EXPECT_TRUE(cell != matrix.table().end() && cell->second.cameras > 0)
          << id << " -> " << to.id << ": nothing was compared";
    }
  }
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
  const Source source = {"kalibr", fs::path(FCA_TESTDATA_DIR) / "formats/kalibr/good/tumvi.yaml", {}};
  const std::string bytes = test::read_file(source.path);
  const std::vector<Sample> samples = samples_of(*find_reader("kalibr")->camera(bytes, 0));
  for (const Format& format : all_formats()) {
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
      // As it is, or as an offset from the image's middle (WoodScape).
      const bool is_centre = std::abs(number.value - centre) < 1e-9 || std::abs(number.value - (centre - 512 / 2 + 0.5)) < 1e-9;
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
