// SPDX-License-Identifier: BSD-3-Clause
// ROS as a consumer of camera_info YAML: camera_calibration_parsers (ros-perception/image_common, parse_yml.cpp with #175 and
// #254 for binning and roi) reads it with yaml-cpp, image_geometry's PinholeCameraModel (ros-perception/vision_opencv,
// pinhole_camera_model.cpp) computes with cv::projectPoints and cv::fisheye. A pixel here is what unrectifyPoint returns for a
// point of the rectified image. A point behind the camera has the pixel of its mirror image there, and here.
//
// It chooses the parser by the file's name (.ini: parse_ini.cpp); here a first line in brackets does.
//
// Coefficients that are all 0 mean that images are rectified already: pixels are P's, and neither K nor R is asked.
// The tables of what the program itself computes (oracles/ros_camera_info) are met to 1e-9 px.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <locale>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "../yaml_directive.h"
#include "fca/code.h"
#include "opencv_formulas.h"
#include "programs.h"

namespace fca::consumers {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;

/// sensor_msgs/CameraInfo
struct CameraInfo {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::string distortion_model = "plumb_bob";
  std::vector<double> D;
  std::array<double, 9> K{};
  std::array<double, 9> R{};
  std::array<double, 12> P{};
  std::uint32_t binning_x = 0;
  std::uint32_t binning_y = 0;
  std::uint32_t x_offset = 0;
  std::uint32_t y_offset = 0;
  std::uint32_t roi_width = 0;
  std::uint32_t roi_height = 0;
};

/// YAML::Node::as<double>, whose stream has the locale of the program around.
double real(const YAML::Node& node) {
  if (node.IsScalar()) {
    const std::string& word = node.Scalar();
    std::stringstream stream(word);
    stream.imbue(std::locale::classic());
    stream.unsetf(std::ios::dec);
    double value = 0.0;
    if (YAML::conversion::ConvertStreamTo(stream, value)) return value;
    if (YAML::conversion::IsInfinity(word)) return std::numeric_limits<double>::infinity();
    if (YAML::conversion::IsNegativeInfinity(word)) return -std::numeric_limits<double>::infinity();
    if (YAML::conversion::IsNaN(word)) return std::numeric_limits<double>::quiet_NaN();
  }
  throw YAML::TypedBadConversion<double>(node.Mark());
}

/// parse_yml.cpp, with sentences in place of asserts.
class Parser {
 public:
  Parser(CameraInfo& info, ConsumerView& view) : info_(info), view_(view) {}

  void parse(const std::string& bytes) {
    const YAML::Node doc = YAML::Load(without_version(bytes));
    key_ = "image_width";
    info_.width = doc[key_].as<std::uint32_t>();
    key_ = "image_height";
    info_.height = doc[key_].as<std::uint32_t>();
    matrix(doc, "camera_matrix", 3, 3, info_.K);
    matrix(doc, "rectification_matrix", 3, 3, info_.R);
    matrix(doc, "projection_matrix", 3, 4, info_.P);
    key_ = "distortion_model";
    if (doc[key_]) info_.distortion_model = doc[key_].as<std::string>();
    coefficients(doc);
    key_ = "binning_x";
    if (doc[key_]) info_.binning_x = doc[key_].as<std::uint32_t>();
    key_ = "binning_y";
    if (doc[key_]) info_.binning_y = doc[key_].as<std::uint32_t>();
    key_ = "roi";
    if (!doc[key_]) return;
    const YAML::Node roi = doc[key_];
    info_.x_offset = roi["x_offset"].as<std::uint32_t>();
    info_.y_offset = roi["y_offset"].as<std::uint32_t>();
    info_.roi_height = roi["height"].as<std::uint32_t>();
    info_.roi_width = roi["width"].as<std::uint32_t>();
    roi["do_rectify"].as<bool>();
  }

  /// What was read last: the parser's own message does not say.
  [[nodiscard]] const char* key() const { return key_; }

 private:
  template <std::size_t N>
  void matrix(const YAML::Node& doc, const char* key, int rows, int cols, std::array<double, N>& into) {
    key_ = key;
    const YAML::Node node = doc[key];
    if (node["rows"].as<int>() != rows || node["cols"].as<int>() != cols) {
      view_.refusals.emplace_back(Code::kRosSaysMatrixSize, key, std::vector<Argument>{key, rows, cols});
      return;
    }
    const YAML::Node data = node["data"];
    for (std::size_t i = 0; i < N; ++i) into.at(i) = real(data[i]);
  }

  void coefficients(const YAML::Node& doc) {
    key_ = "distortion_coefficients";
    const YAML::Node node = doc[key_];
    const int rows = node["rows"].as<int>();
    const int cols = node["cols"].as<int>();
    const YAML::Node data = node["data"];
    constexpr int kMost = 1000;
    if (rows < 0 || cols < 0 || rows > kMost || cols > kMost) {
      view_.refusals.emplace_back(Code::kRosSaysCoefficientsTooMany, key_);
      return;
    }
    for (int i = 0; i < rows * cols; ++i) info_.D.push_back(real(data[i]));
  }

  CameraInfo& info_;
  ConsumerView& view_;
  const char* key_ = "";
};

/// parse_ini.cpp: lines without blanks around them, comments left out.
class IniParser {
 public:
  IniParser(CameraInfo& info, ConsumerView& view) : info_(info), view_(view) {}

  static std::vector<std::string> lines_of(const std::string& bytes) {
    std::vector<std::string> lines;
    std::istringstream stream(bytes);
    for (std::string line; std::getline(stream, line);) {
      constexpr std::string_view kSpace = " \t\n\v\f\r";
      const std::size_t first = line.find_first_not_of(kSpace);
      if (first == std::string::npos || line[first] == '#' || line[first] == ';') continue;
      lines.push_back(line.substr(first, line.find_last_not_of(kSpace) - first + 1));
    }
    return lines;
  }

  static bool is_section(const std::string& line) {
    return line.find('[') != std::string::npos && line.find(']') != std::string::npos;
  }

  /// The number of cameras: each takes the place of the one before.
  std::size_t parse(const std::vector<std::string>& lines) {
    std::size_t cameras = 0;
    for (std::size_t begin = 0; begin < lines.size() && view_.loads();) {
      std::size_t end = begin + 1;
      while (end < lines.size() && !is_section(lines[end])) ++end;
      const std::span<const std::string> section = std::span(lines).subspan(begin, end - begin);
      begin = end;
      if (section.front() == "[externals]") continue;
      if (section.front() == "[image]") {
        info_.width = whole(section, "width");
        info_.height = whole(section, "height");
        continue;
      }
      ++cameras;
      camera(section);
    }
    return cameras;
  }

 private:
  /// The lines after a key.
  std::span<const std::string> behind(std::span<const std::string> section, const std::string& key, std::size_t count) {
    const auto found = std::find(section.begin(), section.end(), key);
    if (static_cast<std::size_t>(section.end() - found) > count)
      return section.subspan(static_cast<std::size_t>(found - section.begin()) + 1, count);
    if (found == section.end()) {
      view_.refusals.emplace_back(Code::kRosSaysKeyMissing, key, std::vector<Argument>{key, section.front()});
    } else {
      view_.refusals.emplace_back(Code::kRosSaysLinesMissing, key, std::vector<Argument>{key});
    }
    return {};
  }

  std::uint32_t whole(std::span<const std::string> section, const std::string& key) {
    const std::span<const std::string> value = behind(section, key, 1);
    if (value.empty()) return 0;
    const long number = std::strtol(value.front().c_str(), nullptr, 10);
    if (number <= 0 || number > INT32_MAX)
      view_.refusals.emplace_back(Code::kRosSaysNoCount, key, std::vector<Argument>{value.front(), key});
    return static_cast<std::uint32_t>(number);
  }

  /// What is no number is nan, and so is all after it.
  std::vector<double> numbers(std::span<const std::string> section, const std::string& key, std::size_t rows,
                              std::size_t columns) {
    std::vector<double> values;
    for (const std::string& line : behind(section, key, rows)) {
      std::istringstream stream(line);
      stream.imbue(std::locale::classic());
      for (std::size_t i = 0; i < columns; ++i) {
        double value = std::numeric_limits<double>::quiet_NaN();
        if (!(stream >> value)) value = std::numeric_limits<double>::quiet_NaN();
        values.push_back(value);
      }
    }
    return values;
  }

  template <std::size_t N>
  void matrix(std::span<const std::string> section, const std::string& key, std::array<double, N>& into) {
    constexpr std::size_t kRows = 3;
    const std::vector<double> values = numbers(section, key, kRows, N / kRows);
    if (values.size() != N) return;
    std::copy(values.begin(), values.end(), into.begin());
    if (std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }))
      view_.refusals.emplace_back(Code::kRosSaysMatrixNotParsed, key, std::vector<Argument>{key});
  }

  void camera(std::span<const std::string> section) {
    constexpr std::size_t kPlumbBob = 5;
    constexpr std::size_t kRational = 8;
    info_.D = numbers(section, "distortion", 1, kRational);
    if (info_.D.size() == kRational && std::isnan(info_.D[kPlumbBob])) info_.D.resize(kPlumbBob);
    info_.distortion_model = info_.D.size() == kPlumbBob ? "plumb_bob" : "rational_polynomial";
    for (const double coefficient : info_.D) {
      if (!std::isnan(coefficient)) continue;
      view_.refusals.emplace_back(Code::kRosSaysCoefficientCount, "distortion");
      break;
    }
    matrix(section, "camera matrix", info_.K);
    matrix(section, "rectification", info_.R);
    matrix(section, "projection", info_.P);
  }

  CameraInfo& info_;
  ConsumerView& view_;
};

/// PinholeCameraModel
class Model {
 public:
  explicit Model(const CameraInfo& info) : K_(info.K), R_(info.R), back_(inverse_of(info.R)), P_(info.P) {
    const bool fisheye = info.distortion_model == "equidistant";
    for (const double coefficient : info.D) calibrated_ = calibrated_ || coefficient != 0.0;
    fisheye_ = fisheye && calibrated_;
    for (std::size_t i = 0; i < std::min(D_.size(), info.D.size()); ++i) D_.at(i) = info.D[i];
    for (std::size_t i = 0; i < std::min(k_.size(), info.D.size()); ++i) k_.at(i) = info.D[i];
    reduce(info);
  }

  [[nodiscard]] bool calibrated() const { return calibrated_; }

  /// The pixel of a ray in the camera's own frame: of the point far away where it meets the rectified camera's plane at z = 1
  /// or z = -1. So this camera's place in the rectified frame does not matter.
  [[nodiscard]] std::optional<Pixel> project(const Ray& ray) const {
    const Ray there = times(R_, ray);
    if (there[2] == 0.0) return std::nullopt;  // project3dToPixel divides by it
    const Pixel pixel = calibrated_ ? distorted(there) : rectified(there);
    if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1])) return std::nullopt;
    return pixel;
  }

  /// How far pixels are off where OpenCV takes R, turned by less than it notices, for no rotation at all.
  [[nodiscard]] double unnoticed_px(double width, double height) const {
    const opencv::Matrix3 exact = opencv::nearest_rotation(R_);
    if (!calibrated_ || opencv::rotation_there_and_back(R_) == exact) return 0.0;
    const double angle = 0.5 * std::hypot(exact[7] - exact[5], exact[2] - exact[6], exact[3] - exact[1]);
    if (!std::isfinite(angle)) return 0.0;
    const double corner = std::max({1.0, width / std::abs(K_[0]), height / std::abs(K_[4])});
    return angle * std::max(std::abs(K_[0]), std::abs(K_[4])) * (1.0 + corner * corner);
  }

 private:
  /// fromCameraInfo: the region is one of the whole image, and so is shifted first.
  void reduce(const CameraInfo& info) {
    K_[2] -= info.x_offset;
    K_[5] -= info.y_offset;
    P_[2] -= info.x_offset;
    P_[6] -= info.y_offset;
    if (info.binning_x > 1) {
      const double scale = 1.0 / info.binning_x;
      for (double* entry : {&K_[0], &K_[2], &P_[0], &P_[2], &P_[3]}) *entry *= scale;
    }
    if (info.binning_y > 1) {
      const double scale = 1.0 / info.binning_y;
      for (double* entry : {&K_[4], &K_[5], &P_[5], &P_[6], &P_[7]}) *entry *= scale;
    }
  }

  static opencv::Matrix3 inverse_of(const opencv::Matrix3& R) {
    return opencv::rotation_there_and_back({R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]});
  }

  static Ray times(const opencv::Matrix3& matrix, const Ray& ray) {
    Ray result{};
    for (std::size_t i = 0; i < matrix.size(); ++i) result.at(i / 3) += matrix.at(i) * ray.at(i % 3);
    return result;
  }

  /// unrectifyPoint, of a point in the rectified frame.
  [[nodiscard]] Pixel distorted(const Ray& there) const {
    const opencv::CameraMatrix K = {K_[0], K_[4], K_[2], K_[5]};
    const Ray ray = times(back_, {there[0] / there[2], there[1] / there[2], 1.0});
    return fisheye_ ? opencv::fisheye_project_points(K, k_, ray) : opencv::project_points(K, D_, ray);
  }

  /// project3dToPixel.
  [[nodiscard]] Pixel rectified(const Ray& there) const {
    return {P_[0] * there[0] / there[2] + P_[2], P_[5] * there[1] / there[2] + P_[6]};
  }

  std::array<double, 9> K_;
  std::array<double, 9> R_;
  opencv::Matrix3 back_;  ///< R's inverse, as OpenCV takes it.
  std::array<double, 12> P_;
  opencv::PinholeCoefficients D_{};
  std::array<double, 4> k_{};
  bool calibrated_ = false;
  bool fisheye_ = false;
};

/// What stops image_geometry, or OpenCV below it.
std::vector<Complaint> problems_of(const CameraInfo& info, const Model& model) {
  std::vector<Complaint> problems;
  const bool opencv = info.distortion_model == "plumb_bob" || info.distortion_model == "rational_polynomial";
  const std::size_t count = info.D.size();
  const auto say = [&problems](Code code, std::string key, std::vector<Argument> arguments = {}) {
    problems.emplace_back(code, std::move(key), std::move(arguments));
  };
  constexpr std::size_t kShown = 40;
  if (!opencv && info.distortion_model != "equidistant") {
    say(Code::kRosSaysUnknownModel, "distortion_model", {info.distortion_model.substr(0, kShown)});
  } else if (opencv && model.calibrated() && count != 4 && count != 5 && count != 8 && count != 12 && count != 14) {
    say(Code::kRosSaysOpenCvCount, "distortion_coefficients", {count});
  } else if (!opencv && model.calibrated() && count != 4) {
    say(Code::kRosSaysFisheyeCount, "distortion_coefficients", {count});
  }
  if (info.P[0] == 0.0 || info.P[5] == 0.0) say(Code::kRosSaysNoFocalLength, "projection_matrix");
  if (info.P[11] != 0.0) say(Code::kRosSaysProjectionCorner, "projection_matrix");
  const std::uint64_t right = static_cast<std::uint64_t>(info.x_offset) + info.roi_width;
  const std::uint64_t bottom = static_cast<std::uint64_t>(info.y_offset) + info.roi_height;
  if (right > info.width || bottom > info.height) say(Code::kRosSaysRoiOutside, "roi");
  return problems;
}

/// Images that are not rectified, taken for rectified ones.
bool is_misread(const CameraInfo& info, const Model& model) {
  if (model.calibrated()) return false;
  if (info.distortion_model == "equidistant") return true;
  constexpr std::array<double, 9> kIdentity = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  return info.R != kIdentity || info.P[0] != info.K[0] || info.P[2] != info.K[2] || info.P[5] != info.K[4] ||
         info.P[6] != info.K[5];
}

/// The number of cameras that were read, of which the last is kept.
std::size_t read(const std::string& bytes, CameraInfo& info, ConsumerView& view) {
  const std::vector<std::string> lines = IniParser::lines_of(bytes);
  if (!lines.empty() && lines.front().front() == '[' && lines.front().back() == ']') {
    const std::size_t cameras = IniParser(info, view).parse(lines);
    if (cameras == 0 && view.loads()) view.refusals.emplace_back(Code::kRosSaysNoCamera, "");
    return cameras;
  }
  Parser parser(info, view);
  try {
    parser.parse(bytes);
  } catch (const YAML::Exception& error) {
    const std::string key = parser.key();
    std::vector<Message> at;
    if (!key.empty()) at = {{Code::kRosSaysAtKey, {key}}};
    view.refusals.emplace_back(Code::kRosSaysNotParsed, key, std::vector<Argument>{at, error.what()});
  }
  return 1;
}

}  // namespace

ConsumerView load_ros(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  if (bytes.size() > kMaxBytes) {
    view.refusals.emplace_back(Code::kProgramFileTooLarge, "");
    return view;
  }
  CameraInfo info;
  const std::size_t cameras = read(std::string(bytes), info, view);
  if (!view.loads()) return view;
  const Model model(info);
  view.refusals = problems_of(info, model);
  if (!view.loads()) return view;

  ConsumerCamera camera;
  camera.name = "cam0";
  const bool whole = info.x_offset == 0 && info.y_offset == 0 && info.roi_width == 0 && info.roi_height == 0;
  camera.width = static_cast<int>((whole ? info.width : info.roi_width) / std::max(info.binning_x, 1U));
  camera.height = static_cast<int>((whole ? info.height : info.roi_height) / std::max(info.binning_y, 1U));
  camera.model = info.distortion_model;
  camera.approximation_px = model.unnoticed_px(camera.width, camera.height);
  const double skew_px = info.K[1];
  camera.misread = is_misread(info, model) || cameras > 1 || skew_px != 0.0;
  if (skew_px != 0.0) view.warnings.emplace_back(Code::kRosSaysSkewUnused, "camera_matrix", std::vector<Argument>{skew_px});
  if (cameras > 1) {
    view.warnings.emplace_back(Code::kRosSaysLastCameraKept, "", std::vector<Argument>{cameras});
  } else if (is_misread(info, model)) {
    const bool fisheye = info.distortion_model == "equidistant";
    view.warnings.emplace_back(fisheye ? Code::kRosSaysFisheyeOfZeros : Code::kRosSaysCoefficientsOfZeros,
                               "distortion_coefficients");
  }
  camera.project = [model](const Ray& ray) { return model.project(ray); };
  view.cameras.push_back(std::move(camera));
  return view;
}

}  // namespace fca::consumers
