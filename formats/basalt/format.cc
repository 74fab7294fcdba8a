// SPDX-License-Identifier: BSD-3-Clause
#include "basalt.h"
#include "layout.h"

#include <fca/code.h>

#include <array>

namespace fca::basalt {

using text::Node;

namespace {

constexpr std::array kModels = {
    StoredModel{"kb4", "kb4", true, "Basalt", {}},
    StoredModel{"ds", "ds", true, "Basalt", {}},
    StoredModel{"eucm", "eucm", true, "Basalt", {}},
    StoredModel{"ucm", "ucm", true, "Basalt", {}},
    StoredModel{"fov", "fov", true, "Basalt", {}},
    StoredModel{"pinhole", "pinhole", true, "Basalt", {}},
    StoredModel{
        .model = "rational", .file_name = "pinhole-radtan8", .read_by = "Basalt since 2022, Monado", .ranges = {}, .since = "2022"},
};

constexpr std::array<std::string_view, 1> kOfTheImages = {kVignette};
constexpr std::array kOwnFacts = {OwnFact{"IMU biases and scale, vignette"}};
constexpr std::array kDemands = {Demand{"pose in the IMU", "T_imu_cam"},
                                 Demand{"IMU noise", "_std", nullptr, &Format::needs_imu},
                                 Demand{"IMU rate", "imu_update_rate", nullptr, &Format::needs_imu}};

ProbeResult found(int score, std::string_view key) { return {score, Message{Code::kBasaltFound, {key}}}; }

ProbeResult probe(const text::Document& document) {
  const Node* value = text::find(document.root(), "value0", kDialect);
  if (value == nullptr || !value->is_mapping()) return {};
  for (const std::string_view key : {"intrinsics", "T_imu_cam"}) {
    if (text::find(*value, key, kDialect) != nullptr) return found(evidence::kCamera, key);
  }
  for (const std::string_view key : kRequired) {
    if (text::find(*value, key, kDialect) != nullptr) return found(evidence::kHint, key);
  }
  return {};
}

}  // namespace

const Format kFormat = {
    .id = "basalt",
    .title = "Basalt calibration",
    .syntaxes = "JSON",
    .extension = ".json",
    .program = "Basalt",
    .many_cameras = true,
    .extrinsics = true,
    .imu = true,
    .needs_imu = true,
    .image_size = true,
    .time_offset = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .of_the_images = kOfTheImages,
    .models = kModels,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::basalt
