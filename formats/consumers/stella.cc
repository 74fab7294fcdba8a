// SPDX-License-Identifier: BSD-3-Clause
// stella_vslam (stella-cv/stella_vslam@b0e60d6 of 2025-07) as a consumer of its configuration: camera/*.cc and
// util/stereo_rectifier.cc, through yaml-cpp. A key that is missing or no number is an exception, but for focal_x_baseline and
// depth_threshold, which then have their defaults. A block that is missing is one without keys.
//
// It turns pixels into rays: cv::undistortPoints in twenty steps, cv::fisheye::undistortPoints, the division model's own
// formula, with K and the coefficients in floats for the former two. What stands here as projection is what these invert. A
// pair that StereoRectifier rectifies is one of raw cameras, from which cv::initUndistortRectifyMap takes the pixels.
//
// OpenVSLAM (xdspacelab/openvslam of 2019 to 2021) reads the same keys with a point between their levels.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../yaml_directive.h"
#include "about_key.h"
#include "fca/code.h"
#include "opencv_formulas.h"
#include "programs.h"

namespace fca::consumers {
namespace {

using opencv::Pixel;
using opencv::Ray;

constexpr std::size_t kMaxBytes = 2U << 20U;
constexpr std::size_t kShown = 40;

/// A program of the family.
struct Program {
  std::string_view name;
  bool dotted;  ///< "Camera.fx"
};
constexpr Program kStella = {"stella_vslam", false};
constexpr Program kOpenVslam = {"OpenVSLAM", true};

/// The number that YAML::Node::as<double> reads; nothing where it throws.
std::optional<double> real(const YAML::Node& node) {
  if (!node.IsDefined() || !node.IsScalar()) return std::nullopt;
  const std::string& word = node.Scalar();
  std::stringstream stream(word);
  stream.imbue(std::locale::classic());
  stream.unsetf(std::ios::dec);
  double value = 0.0;
  if (YAML::conversion::ConvertStreamTo(stream, value)) return value;
  if (YAML::conversion::IsInfinity(word)) return std::numeric_limits<double>::infinity();
  if (YAML::conversion::IsNegativeInfinity(word)) return -std::numeric_limits<double>::infinity();
  if (YAML::conversion::IsNaN(word)) return std::numeric_limits<double>::quiet_NaN();
  return std::nullopt;
}

Message described(const YAML::Node& node) {
  if (node.IsSequence()) return {Code::kValueList};
  if (node.IsMap()) return {Code::kValueMapping};
  if (!node.IsScalar() || node.Scalar().empty()) return {Code::kValueEmpty};
  return {Code::kValueText, {node.Scalar().substr(0, kShown)}};
}

/// The keys of a block, and what the program says of them.
class Block {
 public:
  Block(const YAML::Node& root, const Program& program, std::string name, ConsumerView& view)
      : root_(root), program_(program), name_(std::move(name)), view_(view) {}

  [[nodiscard]] bool is_there() const {
    if (!program_.dotted) return root_[name_].IsDefined();
    return std::any_of(root_.begin(), root_.end(), [this](const auto& entry) {
      return entry.first.IsScalar() && entry.first.Scalar().rfind(name_ + ".", 0) == 0;
    });
  }

  [[nodiscard]] std::string path(const std::string& key) const { return name_ + (program_.dotted ? "." : "/") + key; }

  void refuse(Code code, const std::string& key, std::vector<Argument> arguments) {
    view_.refusals.push_back(about_key(code, path(key), std::move(arguments)));
  }

  [[nodiscard]] YAML::Node find(const std::string& key) const {
    if (program_.dotted) return root_[name_ + "." + key];
    const YAML::Node block = root_[name_];
    return block.IsMap() ? block[key] : YAML::Node(YAML::NodeType::Undefined);
  }

  /// An undefined node, with a refusal, where it is missing.
  YAML::Node require(const std::string& key) {
    YAML::Node node = find(key);
    if (!node.IsDefined()) refuse(Code::kProgramSaysMissing, key, {program_.name});
    return node;
  }

  std::string text(const std::string& key) {
    const YAML::Node node = require(key);
    if (node.IsDefined() && node.IsScalar()) return node.Scalar();
    if (node.IsDefined()) refuse(Code::kProgramSaysNoText, key, {program_.name});
    return "";
  }

  double number(const std::string& key) {
    const YAML::Node node = require(key);
    const std::optional<double> value = real(node);
    if (node.IsDefined() && !value) refuse(Code::kProgramSaysNoNumber, key, {described(node), program_.name});
    return value.value_or(0.0);
  }

  /// as<unsigned int>
  int count(const std::string& key) {
    const YAML::Node node = require(key);
    if (!node.IsDefined()) return 0;
    unsigned int value = 0;
    if (YAML::convert<unsigned int>::decode(node, value) && value <= INT32_MAX) return static_cast<int>(value);
    refuse(Code::kProgramSaysNoNumber, key, {described(node), program_.name});
    return 0;
  }

  /// as<std::vector<double>>; `wanted` 0: of any length. (A shorter list is read beyond its end.)
  std::vector<double> numbers(const std::string& key, std::size_t wanted) {
    const YAML::Node node = require(key);
    std::vector<double> values;
    if (!node.IsDefined()) return values;
    bool good = node.IsSequence();
    for (std::size_t i = 0; good && i < node.size(); ++i) {
      const std::optional<double> value = real(node[i]);
      good = value.has_value();
      values.push_back(value.value_or(0.0));
    }
    if (!good || (wanted != 0 && values.size() < wanted)) {
      refuse(Code::kProgramSaysNumberCount, key, {wanted, program_.name});
      values.assign(std::max(wanted, values.size()), 0.0);
    }
    return values;
  }

  /// One of the words that the program knows; else a refusal.
  std::string word(const std::string& key, const std::string& value, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), value) == known.end() && !value.empty())
      refuse(Code::kProgramSaysUnknownWord, key, {value.substr(0, kShown), program_.name, known});
    return value;
  }

 private:
  const YAML::Node& root_;
  const Program& program_;
  std::string name_;
  ConsumerView& view_;
};

/// cv::Mat_<float>
opencv::CameraMatrix in_floats(const opencv::CameraMatrix& K) {
  return {static_cast<float>(K.fx), static_cast<float>(K.fy), static_cast<float>(K.cx), static_cast<float>(K.cy)};
}

/// cv::undistortPoints with its own criteria: at most 20 steps.
void fill_perspective(const opencv::CameraMatrix& K, const opencv::PinholeCoefficients& d, ConsumerCamera& camera) {
  constexpr int kSteps = 20;
  camera.project = [K, d](const Ray& ray) -> std::optional<Pixel> {
    if (!(ray[2] > 0.0)) return std::nullopt;
    return opencv::project_points(K, d, ray);
  };
  camera.unproject = [K, d](const Pixel& pixel) -> std::optional<Ray> {
    const Pixel point = opencv::undistort_point(K, d, pixel, kSteps);
    return Ray{point[0], point[1], 1.0};
  };
  camera.unproject_fault = {Code::kSlamRaysInSteps, {kSteps}};
}

void fill_fisheye(const opencv::CameraMatrix& K, const std::array<double, 4>& k, ConsumerCamera& camera) {
  camera.project = [K, k](const Ray& ray) -> std::optional<Pixel> {
    if (!(ray[2] > 0.0)) return std::nullopt;
    return opencv::fisheye_project_points(K, k, ray);
  };
  camera.unproject = [K, k](const Pixel& pixel) -> std::optional<Ray> { return opencv::fisheye_undistort_points(K, k, pixel); };
  camera.unproject_fault = {Code::kRaysUpToNinety};
}

/// Its undistort_point, solved for the distorted point: with (X, Y) undistorted, x = X (1 + d (x^2 + y^2)).
void fill_division(const opencv::CameraMatrix& K, double d, ConsumerCamera& camera) {
  camera.project = [K, d](const Ray& ray) -> std::optional<Pixel> {
    if (!(ray[2] > 0.0)) return std::nullopt;
    const double x = ray[0] / ray[2];
    const double y = ray[1] / ray[2];
    const double radicand = 1.0 - 4.0 * d * (x * x + y * y);
    if (radicand < 0.0) return std::nullopt;
    const double factor = 2.0 / (1.0 + std::sqrt(radicand));
    return Pixel{K.cx + K.fx * factor * x, K.cy + K.fy * factor * y};
  };
}

/// What all cameras have.
struct Common {
  std::string setup;
  std::string model;
  int cols = 0;
  int rows = 0;
};

Common read_common(Block& block) {
  Common common;
  common.model = block.word("model", block.text("model"), {"perspective", "fisheye", "equirectangular", "radial_division"});
  block.text("name");
  common.cols = block.count("cols");
  common.rows = block.count("rows");
  block.number("fps");
  if (block.find("color_order").IsDefined())
    block.word("color_order", block.text("color_order"), {"Gray", "RGB", "RGBA", "BGR", "BGRA"});
  if (common.model != "equirectangular")
    common.setup = block.word("setup", block.text("setup"), {"monocular", "stereo", "RGBD"});
  return common;
}

ConsumerCamera empty_camera(const Common& common, const std::string& name, const std::string& model) {
  ConsumerCamera camera;
  camera.name = name;
  camera.model = model;
  camera.width = common.cols;
  camera.height = common.rows;
  return camera;
}

/// An image of all directions: its columns are longitudes, its rows latitudes.
ConsumerCamera panorama_of(const Common& common) {
  constexpr double kPi = 3.14159265358979323846;
  ConsumerCamera camera = empty_camera(common, "cam0", common.model);
  const double cols = common.cols;
  const double rows = common.rows;
  camera.project = [cols, rows](const std::array<double, 3>& ray) -> std::optional<std::array<double, 2>> {
    const double latitude = -std::asin(ray[1] / std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]));
    const double longitude = std::atan2(ray[0], ray[2]);
    return std::array{cols * (0.5 + longitude / (2.0 * kPi)), rows * (0.5 - latitude / kPi)};
  };
  camera.unproject = [cols, rows](const std::array<double, 2>& pixel) -> std::optional<std::array<double, 3>> {
    const double longitude = (pixel[0] / cols - 0.5) * (2.0 * kPi);
    const double latitude = -(pixel[1] / rows - 0.5) * kPi;
    return std::array{std::cos(latitude) * std::sin(longitude), -std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
  };
  return camera;
}

/// The block Camera; `K`: its matrix.
ConsumerCamera read_camera(Block& block, const Common& common, opencv::CameraMatrix& K) {
  ConsumerCamera camera = empty_camera(common, "cam0", common.model);
  K = {block.number("fx"), block.number("fy"), block.number("cx"), block.number("cy")};
  const auto coefficient = [&block](const char* key) { return static_cast<double>(static_cast<float>(block.number(key))); };
  if (common.model == "perspective") {
    opencv::PinholeCoefficients d{};
    std::size_t at = 0;
    for (const char* key : {"k1", "k2", "p1", "p2", "k3"}) d.at(at++) = coefficient(key);
    fill_perspective(in_floats(K), d, camera);
  } else if (common.model == "fisheye") {
    fill_fisheye(in_floats(K), {coefficient("k1"), coefficient("k2"), coefficient("k3"), coefficient("k4")}, camera);
  } else {
    fill_division(K, block.number("distortion"), camera);
  }
  return camera;
}

using Rotation = std::array<double, 9>;

/// One camera of the pair that is rectified, and p_rectified = R p_camera.
ConsumerCamera read_side(Block& block, const Common& common, const std::string& name, const std::string& side,
                         const std::string& model, Rotation& R) {
  constexpr std::size_t kOfMatrix = 9;
  ConsumerCamera camera = empty_camera(common, name, model);
  const std::vector<double> k = block.numbers("K_" + side, kOfMatrix);
  const std::vector<double> r = block.numbers("R_" + side, kOfMatrix);
  const bool fisheye = model == "fisheye";
  const std::vector<double> d = block.numbers("D_" + side, fisheye ? 4 : 0);
  if (k.size() < kOfMatrix || r.size() < kOfMatrix) return camera;
  std::copy_n(r.begin(), R.size(), R.begin());
  const opencv::CameraMatrix K = {k[0], k[4], k[2], k[5]};
  if (fisheye) {
    if (d.size() != 4) {
      block.refuse(Code::kProgramSaysNumberCount, "D_" + side, {4, block.path("model")});
      return camera;
    }
    fill_fisheye(K, {d[0], d[1], d[2], d[3]}, camera);
  } else {
    constexpr std::array<std::size_t, 5> kLengths = {4, 5, 8, 12, 14};
    if (std::find(kLengths.begin(), kLengths.end(), d.size()) == kLengths.end()) {
      block.refuse(Code::kProgramSaysNumberCount, "D_" + side, {5, "OpenCV"});
      return camera;
    }
    opencv::PinholeCoefficients coefficients{};
    std::copy(d.begin(), d.end(), coefficients.begin());
    fill_perspective(K, coefficients, camera);
  }
  // The maps are of rays, and nobody asks for the other direction.
  camera.unproject = nullptr;
  camera.unproject_fault = {};
  return camera;
}

/// T_cam0_cam1 of p_rectified0 = R0 p0, p_rectified1 = R1 p1 and p_rectified0 = p_rectified1 + (baseline, 0, 0).
ConsumerPose pose_of(const Rotation& R0, const Rotation& R1, double baseline) {
  ConsumerPose pose = {"cam0", "cam1", {}};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      double sum = 0.0;
      for (std::size_t i = 0; i < 3; ++i) sum += R0.at(3 * i + row) * R1.at(3 * i + column);
      pose.T_a_b.at(4 * row + column) = sum;
    }
    pose.T_a_b.at(4 * row + 3) = R0.at(row) * baseline;
  }
  pose.T_a_b.back() = 1.0;
  return pose;
}

void read(const YAML::Node& root, const Program& program, ConsumerView& view) {
  Block block(root, program, "Camera", view);
  Block rectifier(root, program, "StereoRectifier", view);
  if (!block.is_there()) {
    view.refusals.push_back(about_key(Code::kProgramSaysMissing, "Camera", {program.name}));
    return;
  }
  const Common common = read_common(block);
  if (!view.loads()) return;
  if (common.model == "equirectangular") {
    view.cameras.push_back(panorama_of(common));
    return;
  }
  opencv::CameraMatrix K;
  ConsumerCamera camera = read_camera(block, common, K);
  const double product = real(block.find("focal_x_baseline")).value_or(0.0);
  if (!rectifier.is_there()) {
    if (!view.loads()) return;
    if (product != 0.0 && common.setup != "monocular") view.baseline_m = product / K.fx;
    view.cameras.push_back(std::move(camera));
    return;
  }
  block.word("setup", common.setup, {"stereo"});
  block.word("model", common.model, {"perspective"});
  const YAML::Node named = rectifier.find("model");
  const std::string model = named.IsDefined() && named.IsScalar() ? named.Scalar() : "perspective";
  rectifier.word("model", model, {"perspective", "fisheye"});
  Rotation left{};
  Rotation right{};
  ConsumerCamera first = read_side(rectifier, common, "cam0", "left", model, left);
  ConsumerCamera second = read_side(rectifier, common, "cam1", "right", model, right);
  if (!view.loads()) return;
  view.cameras = {std::move(first), std::move(second)};
  view.poses.push_back(pose_of(left, right, product / K.fx));
}

ConsumerView load(std::string_view bytes, const Program& program) {
  ConsumerView view;
  if (bytes.size() > kMaxBytes) {
    view.refusals.emplace_back(Code::kProgramFileTooLarge, "");
    return view;
  }
  try {
    const YAML::Node root = YAML::Load(without_version(std::string(bytes)));
    if (root.IsMap()) {
      read(root, program, view);
    } else {
      view.refusals.emplace_back(Code::kProgramSaysNoKeys, "");
    }
  } catch (const YAML::Exception& error) {
    view.cameras.clear();
    view.refusals.emplace_back(Code::kProgramSaysNotParsed, "", std::vector<Argument>{"yaml-cpp", error.what()});
  }
  return view;
}

}  // namespace

ConsumerView load_stella(std::string_view bytes, const LoadOptions& /*options*/) { return load(bytes, kStella); }

ConsumerView load_openvslam(std::string_view bytes, const LoadOptions& /*options*/) { return load(bytes, kOpenVslam); }

}  // namespace fca::consumers
