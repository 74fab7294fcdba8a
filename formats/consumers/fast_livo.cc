// SPDX-License-Identifier: BSD-3-Clause
// FAST-LIVO2 as a consumer of its camera's parameters: rpg_vikit (xuankuzcr/rpg_vikit@6c886c8 of 2025-03), camera_loader.h and
// the cameras in vikit_common, through rosparam, thus PyYAML; the ports to ROS 2 read the same keys below ros__parameters.
//
// getParam takes the nearest int of a real width, and of a number that is missing or a text its default, 0 (with which the
// program goes on, here it is a refusal where no coefficient is meant). A lens whose first coefficient is within 1e-7 of 0 has
// no distortion, whatever the others are. scale multiplies all lengths and shrinks the images (vio.cpp). A ray from behind
// gives the pixel of its mirror image, and EquidistantCamera's ray of the axis the pixel (0, 0).
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "about_key.h"
#include "fca/code.h"
#include "opencv_formulas.h"
#include "programs.h"
#include "pyyaml.h"

namespace fca::consumers {
namespace {

using opencv::Pixel;
using opencv::Ray;
using pyyaml::Kind;
using pyyaml::Value;

constexpr std::string_view kProgram = "FAST-LIVO";

/// As getParam hands the parameters out.
class Parameters {
 public:
  Parameters(const Value& keys, ConsumerView& view) : keys_(keys), view_(view) {}

  /// Of a number that has no default.
  double demanded(const std::string& key) {
    const Value* value = keys_.find(key);
    if (value != nullptr && value->is_number()) return value->number;
    if (value == nullptr) {
      view_.refusals.push_back(about_key(Code::kProgramSaysMissing, key, {kProgram}));
    } else {
      view_.refusals.push_back(about_key(Code::kProgramSaysNoNumber, key, {pyyaml::describe(*value), kProgram}));
    }
    return 0.0;
  }

  /// roscpp's conversion of a real to an int.
  int whole(const std::string& key) {
    const double value = demanded(key);
    constexpr double kLargest = 1e9;
    return static_cast<int>(std::clamp(std::floor(value + 0.5), -kLargest, kLargest));
  }

  double with_default(const std::string& key, double otherwise) {
    const Value* value = keys_.find(key);
    if (value == nullptr || value->is_number()) return value == nullptr ? otherwise : value->number;
    view_.warnings.push_back(about_key(Code::kProgramSaysUnread, key, {kProgram}));
    misread_ = true;
    return otherwise;
  }

  /// Is the lens one with distortion? `first`: the key of its first coefficient.
  bool is_distorted(const std::string& first, double value, bool has_others) {
    constexpr double kNone = 1e-7;
    if (std::abs(value) > kNone) return true;
    if (value != 0.0 || has_others) {
      view_.warnings.push_back(about_key(Code::kFastLivoSaysNoDistortion, first, {value}));
      misread_ = true;
    }
    return false;
  }

  [[nodiscard]] bool misread() const { return misread_; }

 private:
  const Value& keys_;
  ConsumerView& view_;
  bool misread_ = false;
};

/// The map with the camera's keys; null if there is none.
const Value* keys_of(const Value& root) {
  constexpr std::string_view kModel = "cam_model";
  if (root.kind != Kind::kMap) return nullptr;
  if (root.find(kModel) != nullptr) return &root;
  for (const auto& [key, value] : root.entries) {
    if (const Value* below = keys_of(*value)) return below;
  }
  return nullptr;
}

/// PinholeCamera
void fill_pinhole(Parameters& parameters, const opencv::CameraMatrix& K, ConsumerCamera& camera) {
  constexpr std::array<const char*, 4> kKeys = {"cam_d0", "cam_d1", "cam_d2", "cam_d3"};
  opencv::PinholeCoefficients d{};
  for (std::size_t i = 0; i < kKeys.size(); ++i) d.at(i) = parameters.with_default(kKeys.at(i), 0.0);
  const bool others = std::any_of(d.begin() + 1, d.end(), [](double each) { return each != 0.0; });
  if (!parameters.is_distorted(kKeys.front(), d[0], others)) d.fill(0.0);
  camera.project = [K, d](const Ray& ray) -> std::optional<Pixel> { return opencv::project_points(K, d, ray); };
  if (d[0] == 0.0) return;
  camera.unproject = opencv::undistorted_rays(K, d);
  camera.unproject_fault = {Code::kRaysInFiveSteps};
}

/// EquidistantCamera
void fill_equidistant(Parameters& parameters, const opencv::CameraMatrix& K, ConsumerCamera& camera) {
  constexpr std::array<const char*, 4> kKeys = {"k1", "k2", "k3", "k4"};
  std::array<double, 4> k{};
  for (std::size_t i = 0; i < kKeys.size(); ++i) k.at(i) = parameters.with_default(kKeys.at(i), 0.0);
  // Without distortion it is a pinhole, and so an equidistant lens without coefficients is misread, too.
  if (!parameters.is_distorted(kKeys.front(), k[0], true)) {
    camera.project = [K](const Ray& ray) -> std::optional<Pixel> { return opencv::project_points(K, {}, ray); };
    return;
  }
  // Within 1e-8 of its axis it forgets the camera matrix: no point of an image is so close.
  camera.project = [K, k](const Ray& ray) -> std::optional<Pixel> { return opencv::fisheye_project_points(K, k, ray); };
  constexpr int kSteps = 5;
  camera.unproject = [K, k](const Pixel& pixel) -> std::optional<Ray> {
    const double x = (pixel[0] - K.cx) / K.fx;
    const double y = (pixel[1] - K.cy) / K.fy;
    const double distorted = std::hypot(x, y);
    double theta = distorted;
    for (int step = 0; step < kSteps; ++step) {
      const double t2 = theta * theta;
      theta = distorted / (1.0 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
    }
    const double factor = std::tan(theta) / distorted;
    return Ray{x * factor, y * factor, 1.0};
  };
  camera.unproject_fault = {Code::kSlamRaysInSteps, {kSteps}};
}

/// ATANCamera: its lengths are shares of the image's sides.
void fill_atan(Parameters& parameters, const opencv::CameraMatrix& shares, ConsumerCamera& camera) {
  const double angle = parameters.demanded("cam_d0");
  const opencv::CameraMatrix K = {.fx = camera.width * shares.fx,
                                  .fy = camera.height * shares.fy,
                                  .cx = camera.width * shares.cx - 0.5,
                                  .cy = camera.height * shares.cy - 0.5};
  const double twice_tan = 2.0 * std::tan(angle / 2.0);
  camera.project = [K, angle, twice_tan](const Ray& ray) -> std::optional<Pixel> {
    const double x = ray[0] / ray[2];
    const double y = ray[1] / ray[2];
    const double r = std::hypot(x, y);
    constexpr double kNearAxis = 0.001;
    const double factor = r < kNearAxis || angle == 0.0 ? 1.0 : std::atan(r * twice_tan) / (angle * r);
    return Pixel{K.cx + K.fx * factor * x, K.cy + K.fy * factor * y};
  };
  // What the shortcut near the axis is off by.
  if (angle != 0.0) camera.approximation_px = 0.001 * std::max(K.fx, K.fy) * std::abs(1.0 - twice_tan / angle);
}

void load_camera(const Value& keys, ConsumerView& view) {
  Parameters parameters(keys, view);
  const std::string model = keys.find("cam_model")->text;
  constexpr std::array<const char*, 5> kKnown = {"Pinhole", "EquidistantCamera", "PolynomialCamera", "ATAN", "Ocam"};
  if (std::find(kKnown.begin(), kKnown.end(), model) == kKnown.end()) {
    const std::vector<std::string> known(kKnown.begin(), kKnown.end());
    view.refusals.push_back(about_key(Code::kProgramSaysUnknownWord, "cam_model", {model.substr(0, 40), kProgram, known}));
    return;
  }
  if (model == "PolynomialCamera" || model == "Ocam") return;
  ConsumerCamera camera;
  camera.name = "cam0";
  camera.model = model;
  const double scale = model == "ATAN" ? 1.0 : parameters.with_default("scale", 1.0);
  constexpr double kMostPixels = 1e9;
  camera.width = static_cast<int>(std::clamp(parameters.whole("cam_width") * scale, 0.0, kMostPixels));
  camera.height = static_cast<int>(std::clamp(parameters.whole("cam_height") * scale, 0.0, kMostPixels));
  camera.scale = {scale, scale};
  const opencv::CameraMatrix K = {.fx = parameters.demanded("cam_fx") * scale,
                                  .fy = parameters.demanded("cam_fy") * scale,
                                  .cx = parameters.demanded("cam_cx") * scale,
                                  .cy = parameters.demanded("cam_cy") * scale};
  if (model == "Pinhole") fill_pinhole(parameters, K, camera);
  if (model == "EquidistantCamera") fill_equidistant(parameters, K, camera);
  if (model == "ATAN") fill_atan(parameters, K, camera);
  camera.misread = parameters.misread();
  if (view.loads()) view.cameras.push_back(std::move(camera));
}

}  // namespace

ConsumerView load_fast_livo(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  const pyyaml::Loaded loaded = pyyaml::safe_load(bytes);
  if (!loaded.root) {
    view.refusals.emplace_back(Code::kProgramSaysNotParsed, "", std::vector<Argument>{"PyYAML", loaded.error});
    return view;
  }
  const Value* keys = keys_of(*loaded.root);
  if (keys == nullptr) {
    view.refusals.push_back(about_key(Code::kProgramSaysMissing, "cam_model", {kProgram}));
    return view;
  }
  load_camera(*keys, view);
  return view;
}

}  // namespace fca::consumers
