// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "orbslam3.h"
#include "pair.h"
#include "settings.h"

#include <fca/code.h>

#include <algorithm>
#include <array>

namespace fca::orbslam3 {

namespace {

/// Both EUCM forks compute a validity radius 1 / (beta (2 alpha - 1)) without guarding alpha: below 0.5 it is negative and they
/// reject every point. A little above 0.5 keeps it far outside any image.
constexpr std::array kAlphaAboveHalf = {ParameterRange{"alpha", 0.501, 1.0}};

constexpr std::array kModels = {
    StoredModel{"radtan", "PinHole", true, "ORB-SLAM3 V1.0", {}},
    StoredModel{"kb4", "KannalaBrandt8", true, "ORB-SLAM3 V1.0 (right rays inside 90 deg)", {}},
    StoredModel{"pinhole", "PinHole, Rectified", true, "ORB-SLAM3 V1.0", {}},
    StoredModel{"eucm", "EUCM", false, "ns15417/slam_no_opt, lsyads/fisheye-ORB-SLAM", kAlphaAboveHalf,
                Code::kOrbslam3AlphaAboveHalf},
    StoredModel{"ds", "DoubleSphere", false, "urbste/ORB_SLAM3 (branch feature/gopro_slam)", {}},
};

/// One member of every row of a table.
template <class Row, std::size_t kCount>
constexpr std::array<std::string_view, kCount> names_of(const std::array<Row, kCount>& rows, std::string_view Row::*name) {
  std::array<std::string_view, kCount> names;
  std::ranges::transform(rows, names.begin(), name);
  return names;
}

constexpr std::array kOwnFacts = {OwnFact{"tuning (ORBextractor, Viewer, RGB, overlapping)"}};
constexpr std::array kDemands = {
    Demand{"frame rate", "Camera.fps", nullptr, &Format::frame_rate},
    Demand{"colour order", "Camera.RGB"},
    Demand{"depth threshold", "ThDepth", &Format::extrinsics},
    Demand{"overlapping columns", "lapping", &Format::extrinsics},
    Demand{"ORBextractor.*", "ORBextractor"},
    Demand{"Viewer.*", "Viewer"},
};

/// Of the ROS examples and of ORB-SLAM3's rescaling.
constexpr std::array<std::string_view, 10> kOfTheImages = {"LEFT.P",          "LEFT.K",          "LEFT.height",  "LEFT.width",
                                                           "RIGHT.P",         "RIGHT.K",         "RIGHT.height", "RIGHT.width",
                                                           "Camera.newWidth", "Camera.newHeight"};
/// Of both raw cameras and their rectification, as stereo_euroc reads them next to Camera.*.
constexpr std::array<std::string_view, 8> kOfTheLenses = {"LEFT.D",  "LEFT.K",  "LEFT.R",  "LEFT.P",
                                                          "RIGHT.D", "RIGHT.K", "RIGHT.R", "RIGHT.P"};

constexpr auto kModes = names_of(kSensors, &Sensor::id);
constexpr auto kLayouts = names_of(kStyleNames, &StyleName::name);

ProbeResult probe(const text::Document& document) {
  for (const std::string_view key : {"Camera1.fx", "Camera.fx"}) {
    if (find_key(document, key) != nullptr) return {evidence::kCamera, Message{Code::kFoundKey, {key}}};
  }
  if (find_key(document, "File.version") != nullptr && find_key(document, "Camera.type") != nullptr)
    return {evidence::kPart, Message{Code::kFoundKeys, {std::vector<std::string>{"File.version", "Camera.type"}}}};
  if (find_key(document, "ORBextractor.nFeatures") != nullptr)
    return {evidence::kTuning, Message{Code::kFoundKey, {"ORBextractor.nFeatures"}}};
  return {};
}

bool layout_holds(const text::Document& document, std::string_view model) {
  return find_layout(style_of(document), model) != nullptr;
}

bool layout_stores(std::string_view layout, std::string_view model) {
  const std::optional<Style> named = style_named(layout);
  return named && find_layout(*named, model) != nullptr;
}

}  // namespace

const Format kFormat = {
    .id = "orbslam3",
    .title = "ORB-SLAM3 settings",
    .syntaxes = "OpenCV YAML",
    .extension = ".yaml",
    .program = "ORB-SLAM3",
    .many_cameras = true,
    .most_cameras = 2,
    .begins_with_pair = true,
    .one_model = true,
    .extrinsics = true,
    .imu = true,
    .image_size = true,
    .frame_rate = true,
    .baseline = true,
    .own_facts = kOwnFacts,
    .modes = kModes,
    .layouts = kLayouts,
    .about_layouts = Code::kOrbslam3Layouts,
    .common_lens_layout = kCommonLens,
    .rectified = RectifiedFiles::kImages,
    .demands = kDemands,
    .of_the_images = kOfTheImages,
    .of_the_lenses = kOfTheLenses,
    .models = kModels,
    .probe = probe,
    .range_of = range_of,
    .optional_value = optional_value,
    .layout_holds = layout_holds,
    .cameras_held = cameras_held,
    .layout_stores = layout_stores,
    .matches_along_rows = matches_along_rows,
    .read = read,
    .write = write,
};

}  // namespace fca::orbslam3
