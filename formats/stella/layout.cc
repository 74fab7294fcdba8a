// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include "../ros/rectification.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/rig/stereo_order.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <array>

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

/// Does P put the second camera to the right of the first, in rows of the same height?
bool is_side_by_side(const Rig& rig) {
  const ros::Rectification rectification = ros::rectification_of(rig);
  const ros::Projection& left = rectification.cameras[0].P;
  const ros::Projection& right = rectification.cameras[1].P;
  const bool alike = left[0] == right[0] && left[2] == right[2] && left[5] == right[5] && left[6] == right[6];
  return alike && left[3] == 0.0 && left[7] == 0.0 && right[3] < 0.0 && right[7] == 0.0;
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

bool is_pair(const Rig& rig, std::vector<Message>& why_not) {
  if (rig.cameras.size() < 2) return false;
  const Camera& first = rig.cameras[0];
  const Camera& second = rig.cameras[1];
  const auto lacks = [&why_not](Message what) {
    why_not = {Message{Code::kOrbslam3ModeLacks, {kStereo, std::move(what)}}};
    return false;
  };
  // OpenCV's longer lists are read, and edited where they stand.
  const auto is_longer = [](const CameraModel& model) { return opencv_count(model_info(model).id) > kRadtanCount; };
  const Lens* left = lens_of(first.model);
  const Lens* right = lens_of(second.model);
  const bool both_longer = is_longer(first.model) && is_longer(second.model);
  if (!both_longer && (left == nullptr || left != right || !may_be_rectified(*left))) return lacks({Code::kStellaLacksLens});
  if (first.image_size != second.image_size) return lacks({Code::kOrbslam3LacksOneSize});
  if (!rig.resolve(first.name, second.name)) return lacks({Code::kOrbslam3LacksPose, {second.name, first.name}});
  if (second_below_first(rig)) {
    why_not = {Message{Code::kOrbslam3NoRows, {first.name, second.name}}};
    return false;
  }
  if (may_be_stereo(rig, first, second) && is_side_by_side(rig)) return true;
  if (!second_left_of_first(rig)) why_not = {Message{Code::kOrbslam3NoPair, {first.name, second.name}}};
  return false;
}

}  // namespace fca::stella
