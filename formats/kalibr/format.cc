// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "demands.h"
#include "kalibr.h"
#include "layout.h"
#include "overlaps.h"
#include "report.h"

#include "../known_formats.h"

#include <fca/code.h>

#include <array>

namespace fca::kalibr {

using text::Node;

namespace {

constexpr std::array kModels = {
    StoredModel{"radtan", "pinhole-radtan", true, "Kalibr", kNoK3, Code::kCamchainRadtanNoK3},
    StoredModel{"kb4", "pinhole-equidistant", true, "Kalibr (rays inside 90 deg)", {}},
    StoredModel{"mei", "omni-radtan", true, "Kalibr", {}},
    StoredModel{"eucm", "eucm-none", true, "Kalibr", kAlphaRange, Code::kCamchainAlphaBelowOne},
    StoredModel{"ds", "ds-none", true, "Kalibr", kAlphaRange, Code::kCamchainAlphaBelowOne},
    StoredModel{"ucm", "eucm-none with beta = 1", true, "Kalibr", kAlphaRange, Code::kCamchainAlphaBelowOne},
    StoredModel{"fov", "pinhole-fov", true, "Kalibr (w in [0.5, 1.5])", {}},
    StoredModel{"pinhole", "pinhole-radtan with zeros", true, "Kalibr", {}},
};

constexpr std::array<std::string_view, 1> kOfTheImages = {"line_delay"};
constexpr std::array kOfCameras = {kOverlaps};
constexpr std::array kOwnFacts = {OwnFact{"keys of its own (cam_overlaps)"}};
constexpr std::array kDemands = {Demand{"IMU topic", "rostopic", &Format::imu}};

ProbeResult probe(const text::Document& document) {
  if (is_report(document))
    return {evidence::kPart, Message{Code::kFoundKeys, {std::vector<std::string>{"Calibration results"}}}};
  const Node& root = document.root();
  for (const text::Entry& entry : root.entries) {
    if (!index_in(entry.key.value, "cam") || !entry.value.is_mapping()) continue;
    for (const schema::Key& key : kCameraBlock.keys) {
      if (text::find(entry.value, key.name, text::Dialect::kPyYaml) != nullptr) {
        // apex-camera-models' cameras have Kalibr's keys, too, and no distortion_model.
        if (looks_like(document.source().bytes, Parsed::kYes).code == Code::kLooksLikeApex) return {};
        return {evidence::kCamera, Message{Code::kCamchainWithKey, {entry.key.value, key.name}}};
      }
    }
  }
  for (const text::Entry& entry : root.entries) {
    if (index_in(entry.key.value, "cam")) return {evidence::kHint, Message{Code::kCamchainBlock, {entry.key.value}}};
  }
  if (holds_noise(root)) return {evidence::kPart, Message{Code::kCamchainImuKeys}};
  for (const text::Entry& entry : root.entries) {
    if (index_in(entry.key.value, "imu") && entry.value.is_mapping() && holds_noise(entry.value)) {
      return {evidence::kPart, Message{Code::kCamchainWithKey, {entry.key.value, "noise densities"}}};
    }
  }
  return {};
}

/// ConfigReader.py: what it asks for as soon as it opens a bag, and the offset it starts from where a chain specifies one.
std::optional<ValueType> optional_value(const text::Document& document, std::string_view key) {
  const std::size_t slash = key.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const std::string_view owner = key.substr(0, slash);
  const std::string_view name = key.substr(slash + 1);
  const Node* block = text::find(document.root(), owner, dialect_of(document));
  if (block == nullptr || !block->is_mapping()) return std::nullopt;
  const bool of_camera = index_in(owner, "cam").has_value();
  if (name == "rostopic" && (of_camera || index_in(owner, "imu"))) return ValueType::kText;
  return of_camera && name == "timeshift_cam_imu" ? std::optional(ValueType::kReal) : std::nullopt;
}

}  // namespace

const Format kFormat = {
    .id = "kalibr",
    .title = "Kalibr camchain",
    .group = FormatGroup::kCalibration,
    .syntaxes = "YAML",
    .extension = ".yaml",
    .program = "Kalibr",
    .many_cameras = true,
    .extrinsics = true,
    .imu = true,
    .imu_file = true,
    .image_size = true,
    .time_offset = true,
    .topic = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .of_the_images = kOfTheImages,
    .of_cameras = kOfCameras,
    .models = kModels,
    .table = &kChain,
    .probe = probe,
    .optional_value = optional_value,
    .read = read,
    .write = write,
};

}  // namespace fca::kalibr
