// SPDX-License-Identifier: BSD-3-Clause
#include "camera_info.h"
#include "ini.h"
#include "layout.h"
#include "rectification.h"
#include "ros.h"

#include <fca/code.h>

#include <array>

namespace fca::ros {

using text::Node;

namespace {

constexpr std::array kModels = {
    StoredModel{"radtan", "plumb_bob", true, "image_geometry", {}},
    StoredModel{"rational", "rational_polynomial", true, "image_geometry", {}},
    StoredModel{"opencv14", "rational_polynomial of 12 or 14", true, "image_geometry", {}},
    StoredModel{"kb4", "equidistant", true, "image_geometry (rays inside 90 deg)", {}},
    StoredModel{"radtan-skew", "plumb_bob with K(0, 1)", false, "image_geometry without the skew", {}},
    StoredModel{"rational-skew", "rational_polynomial with K(0, 1)", false, "image_geometry without the skew", {}},
    StoredModel{"opencv14-skew", "rational_polynomial of 12 or 14 with K(0, 1)", false, "image_geometry without the skew", {}},
    StoredModel{"kb4-skew", "equidistant with K(0, 1)", false, "image_geometry without the skew", {}},
    StoredModel{"pinhole", "plumb_bob with zeros", true, "image_geometry", {}},
};

constexpr std::array kOwnFacts = {OwnFact{"rectified image (projection_matrix), binning, roi"}};
constexpr std::array<std::string_view, 4> kOfTheImages = {kProjection, "binning_x", "binning_y", "roi"};
constexpr std::array<std::string_view, 1> kOfTheLenses = {kProjection};

bool is_plain_matrix(const Node* node) {
  return node != nullptr && node->is_mapping() && !node->tag.ends_with("opencv-matrix") &&
         text::find(*node, "dt", kDialect) == nullptr && text::find(*node, "data", kDialect) != nullptr;
}

ProbeResult probe(const text::Document& document) {
  if (document.syntax() == text::Syntax::kWords)
    return looks_like_ini(document) ? ProbeResult{evidence::kCamera, Message{Code::kFoundIniSections}} : ProbeResult{};
  if (is_message(document)) return {evidence::kCamera, Message{Code::kRosMessage}};
  const Node& root = document.root();
  const bool camera = is_plain_matrix(text::find(root, kMatrix, kDialect));
  for (const std::string_view key : {kRectification, kProjection, kCoefficients}) {
    if (!is_plain_matrix(text::find(root, key, kDialect))) continue;
    if (camera) {
      const std::vector<std::string> both = {std::string(kMatrix), std::string(key)};
      return {evidence::kCamera, Message{Code::kFoundMatrices, {both}}};
    }
    return {evidence::kHint, Message{Code::kFoundMatrices, {key}}};
  }
  if (camera) return {evidence::kHint, Message{Code::kFoundMatrices, {kMatrix}}};
  return {};
}

bool layout_holds(const text::Document& document, std::string_view model) {
  return document.syntax() != text::Syntax::kWords || ini_holds(model);
}

}  // namespace

const Format kFormat = {
    .id = "ros",
    .title = "ROS camera_info",
    .group = FormatGroup::kCalibration,
    .syntaxes = "YAML, INI",
    .extension = ".yaml",
    .program = "ROS",
    .many_cameras = false,
    .begins_with_pair = true,
    .undistorts_points = true,
    .extrinsics = true,
    .pair_poses = true,
    .imu = false,
    .image_size = true,
    .frame = "rectified",
    .own_facts = kOwnFacts,
    .rectified = RectifiedFiles::kCameras,
    .of_the_images = kOfTheImages,
    .of_the_lenses = kOfTheLenses,
    .models = kModels,
    .probe = probe,
    .layout_holds = layout_holds,
    .as_stated = as_stated,
    .complete = find_rectified_pair,
    .read = read,
    .write = write,
};

}  // namespace fca::ros
