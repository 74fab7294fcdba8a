// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/rig/stereo_order.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::stella {

namespace {

constexpr std::array kBrown = {Coefficient{"k1", "k1"}, Coefficient{"k2", "k2"}, Coefficient{"p1", "p1"},
                               Coefficient{"p2", "p2"}, Coefficient{"k3", "k3"}};
constexpr std::array kEquidistant = {Coefficient{"k1", "k1"}, Coefficient{"k2", "k2"}, Coefficient{"k3", "k3"},
                                     Coefficient{"k4", "k4"}};
constexpr std::array kDivision = {Coefficient{"distortion", "k"}};

constexpr std::array kLenses = {Lens{"perspective", "radtan", kBrown}, Lens{"fisheye", "kb4", kEquidistant},
                                Lens{"radial_division", "division", kDivision},
                                Lens{"division_undistortion", "division", kDivision}};  // OpenVSLAM's first name for it

/// Do both look at one rectified image, in rows of the same height?
bool is_level(const ros::Rectification& rectification) {
  const ros::Projection& left = rectification.cameras[0].P;
  const ros::Projection& right = rectification.cameras[1].P;
  const bool alike = left[0] == right[0] && left[2] == right[2] && left[5] == right[5] && left[6] == right[6];
  constexpr double kRounding = 1e-9;  // m
  return alike && std::abs(left[7]) <= kRounding * left[5] && std::abs(right[7]) <= kRounding * right[5];
}

/// The same cameras, each with a pinhole of its focal lengths and centre: how a pair is rectified depends on no more.
Rig with_plain_lenses(const Rig& rig) {
  Rig plain = rig;
  for (Camera& camera : plain.cameras) {
    const auto focal_lengths = central_focal_lengths(camera.model);
    const Pixel centre = principal_point(camera.model);
    camera.model = *make_model("pinhole");
    static_cast<void>(set_parameter(camera.model, "fx", focal_lengths[0]));
    static_cast<void>(set_parameter(camera.model, "fy", focal_lengths[1]));
    static_cast<void>(set_parameter(camera.model, "cx", centre[0]));
    static_cast<void>(set_parameter(camera.model, "cy", centre[1]));
  }
  return plain;
}

}  // namespace

Style style_of(const text::Document& document) {
  const text::Node* camera = text::find(document.root(), kCamera, kDialect);
  return camera != nullptr && camera->is_mapping() ? Style::kNested : Style::kDotted;
}

const text::Node* find_key(const text::Document& document, std::string_view block, std::string_view key) {
  if (style_of(document) == Style::kDotted)
    return text::find(document.root(), std::string(block) + "." + std::string(key), kDialect);
  const text::Node* node = text::find(document.root(), block, kDialect);
  return node != nullptr ? text::find(*node, key, kDialect) : nullptr;
}

const Lens* find_lens(std::string_view name) {
  const auto* const found = std::ranges::find(kLenses, name, &Lens::name);
  return found == kLenses.end() ? nullptr : &*found;
}

const Lens* lens_of(const CameraModel& model) {
  const std::string_view id = model_info(model).id;
  const auto* const found = std::ranges::find(kLenses, id == "pinhole" ? "radtan" : id, &Lens::model);
  return found == kLenses.end() ? nullptr : &*found;
}

std::vector<std::string> lens_names() { return {"perspective", "fisheye", "radial_division"}; }

bool may_be_rectified(const Lens& lens) { return lens.model == "radtan" || lens.model == "kb4"; }

std::vector<double> coefficients_of(const CameraModel& model) {
  std::vector<double> values;
  if (const std::size_t count = opencv_count(model_info(model).id)) {
    for (const ParameterId id : std::span(kOpenCvCoefficients).first(count)) values.push_back(parameter(model, id).value());
    return values;
  }
  const Lens* lens = lens_of(model);
  for (const Coefficient& each : lens != nullptr ? lens->coefficients : std::span<const Coefficient>())
    values.push_back(parameter(model, each.parameter).value_or(0.0));
  return values;
}

ros::Rectification rectification_of(const Rig& rig) {
  ros::Rectification stated = ros::rectification_of(rig);
  const std::string& first = rig.cameras[0].name;
  const std::string& second = rig.cameras[1].name;
  const std::optional<Transform> T = rig.resolve(second, first);
  if (is_level(stated) || !T) return stated;
  Rig pair;
  pair.cameras = {rig.cameras[0], rig.cameras[1]};
  pair.poses = {{second, first, *T}};
  return ros::rectification_of(pair);
}

double focal_times_baseline(const ros::Rectification& rectification) {
  return rectification.cameras[0].P[3] - rectification.cameras[1].P[3];
}

bool stands_as_pair(const Rig& rig, std::vector<Message>& why_not) {
  if (rig.cameras.size() < 2) return false;
  const Camera& first = rig.cameras[0];
  const Camera& second = rig.cameras[1];
  const auto lacks = [&why_not](Message what) {
    why_not = {Message{Code::kOrbslam3ModeLacks, {kStereo, std::move(what)}}};
    return false;
  };
  if (first.image_size != second.image_size) return lacks({Code::kOrbslam3LacksOneSize});
  if (!rig.resolve(first.name, second.name)) return lacks({Code::kOrbslam3LacksPose, {second.name, first.name}});
  if (second_below_first(rig)) {
    why_not = {Message{Code::kOrbslam3NoRows, {first.name, second.name}}};
    return false;
  }
  const ros::Rectification rectification = rectification_of(with_plain_lenses(rig));
  if (may_be_stereo(rig, first, second) && is_level(rectification) && focal_times_baseline(rectification) > 0.0) return true;
  if (!second_left_of_first(rig)) why_not = {Message{Code::kOrbslam3NoPair, {first.name, second.name}}};
  return false;
}

bool is_pair(const Rig& rig, std::vector<Message>& why_not) {
  if (!stands_as_pair(rig, why_not)) return false;
  // OpenCV's longer lists are read, and edited where they stand.
  const auto is_longer = [](const Camera& camera) { return opencv_count(model_info(camera.model).id) > kRadtanCount; };
  const Lens* left = lens_of(rig.cameras[0].model);
  const Lens* right = lens_of(rig.cameras[1].model);
  if (is_longer(rig.cameras[0]) && is_longer(rig.cameras[1])) return true;
  if (left != nullptr && left == right && may_be_rectified(*left)) return true;
  why_not = {Message{Code::kOrbslam3ModeLacks, {kStereo, Message{Code::kStellaLacksLens}}}};
  return false;
}

}  // namespace fca::stella
