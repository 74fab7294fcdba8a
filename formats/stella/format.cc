// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "stella.h"

#include <fca/code.h>

#include <array>

namespace fca::stella {

namespace {

constexpr std::array kModels = {
    StoredModel{"radtan", "perspective", true, kProgram, {}},
    StoredModel{"kb4", "fisheye", true, "stella_vslam (rays inside 90 deg)", {}},
    StoredModel{"division", "radial_division", true, kProgram, {}},
    StoredModel{"pinhole", "perspective with zeros", true, kProgram, {}},
};
constexpr std::array kOwnFacts = {OwnFact{"name, colour order, tuning (Feature, Mapping, ...)"}};
constexpr std::array kDemands = {Demand{"frame rate", "Camera.fps", nullptr, &Format::frame_rate},
                                 Demand{"colour order", kColourOrder}};
constexpr std::array<std::string_view, 2> kLayouts = {kStellaVslam, kOpenVslam};
constexpr std::array<std::string_view, 2> kOfTheImages = {"stella.Preprocessing", "projection_matrix"};
constexpr std::array<std::string_view, 1> kOfTheLenses = {"projection_matrix"};

ProbeResult probe(const text::Document& document) {
  if (!document.root().is_mapping()) return {};
  constexpr int kOrbSlamsKeysToo = 5;  // ORB-SLAM2's settings have the dotted ones
  const auto has = [&document](std::string_view key) { return find_key(document, kCamera, key) != nullptr; };
  const auto found = [&document](std::string_view a, std::string_view b) {
    const std::string separator = style_of(document) == Style::kDotted ? "." : "/";
    const std::string head = std::string(kCamera) + separator;
    return Message{Code::kFoundKeys, {std::vector<std::string>{head + std::string(a), head + std::string(b)}}};
  };
  for (const std::string_view key : {"model", "cols"}) {
    if (has("setup") && has(key)) return {evidence::kCamera + kOrbSlamsKeysToo, found("setup", key)};
  }
  if (has("model") && has("cols")) return {evidence::kCamera + kOrbSlamsKeysToo, found("model", "cols")};
  return {};
}

/// A camera of a pair that is not rectified can be of a lens that StereoRectifier takes, and no other.
bool layout_holds(const text::Document& document, std::string_view model) {
  const std::string_view id = model == "pinhole" ? "radtan" : model;
  const bool pair = find_key(document, kRectifier, "K_left") != nullptr;
  return !pair || id == "radtan" || id == "kb4";
}

/// Of rectified images.
bool matches_along_rows(std::string_view /*model*/) { return true; }

}  // namespace

const Format kFormat = {
    .id = "stella",
    .title = "stella_vslam configuration",
    .syntaxes = "YAML",
    .extension = ".yaml",
    .program = kProgram,
    .many_cameras = true,
    .most_cameras = 2,
    .begins_with_pair = true,
    .one_model = true,
    .extrinsics = true,
    .pair_poses = true,
    .imu = false,
    .image_size = true,
    .frame_rate = true,
    .baseline = true,
    .frame = "rectified",
    .own_facts = kOwnFacts,
    .layouts = kLayouts,
    .about_layouts = Code::kStellaLayouts,
    .demands = kDemands,
    .of_the_images = kOfTheImages,
    .of_the_lenses = kOfTheLenses,
    .models = kModels,
    .probe = probe,
    .layout_holds = layout_holds,
    .cameras_held = cameras_held,
    .matches_along_rows = matches_along_rows,
    .read = read,
    .write = write,
};

}  // namespace fca::stella
