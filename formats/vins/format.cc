// SPDX-License-Identifier: BSD-3-Clause
#include "camera_file.h"
#include "config.h"
#include "vins.h"

#include <fca/code.h>

#include <array>

namespace fca::vins {

namespace {

constexpr std::string_view kReaders = "VINS-Mono, VINS-Fusion";
constexpr std::array kNoK3 = {ParameterRange{"k3", 0.0, 0.0}};
constexpr std::array kDegreeFour = {ParameterRange{"a5", 0.0, 0.0}, ParameterRange{"a6", 0.0, 0.0},
                                    ParameterRange{"a7", 0.0, 0.0}, ParameterRange{"a8", 0.0, 0.0}};
constexpr std::array kModels = {
    StoredModel{"radtan", "PINHOLE", true, kReaders, kNoK3, Code::kVinsPinholeNoK3},
    StoredModel{"rational", "PINHOLE_FULL", true, "VINS-Fusion", {}},
    StoredModel{"mei", "MEI", true, kReaders, {}},
    StoredModel{"kb4", "KANNALA_BRANDT", true, kReaders, {}},
    StoredModel{"ocamcalib", "scaramuzza", true, kReaders, kDegreeFour, Code::kVinsDegreeFour},
    StoredModel{"pinhole", "PINHOLE", true, kReaders, {}},
};
constexpr std::array<std::string_view, 1> kInverse = {"inverse polynomial"};
constexpr std::array kOwnFacts = {OwnFact{"keys of its own (VINS-Fusion's configuration)"},
                                  OwnFact{"the inverse polynomial", kInverse}};
constexpr std::array kDemands = {
    Demand{.name = "inverse polynomial (fitted)", .key = "inverse polynomial", .of_model = "ocamcalib"}};

ProbeResult probe(const text::Document& document) {
  if (!is_yaml(document)) return {};
  const auto has = [&document](std::string_view key) { return text::find(document.root(), key, kDialect) != nullptr; };
  for (const std::string_view section : {"projection_parameters", "poly_parameters"}) {
    if (has(section)) return {evidence::kCamera, Message{Code::kFoundTopLevel, {section}}};
  }
  // D2SLAM's settings have VINS' keys; its program reads further files, and lenses of its own.
  if (has("estimation_mode") && (has("self_id") || has("double_counting_common_feature"))) return {};
  // OV2SLAM's settings have body_T_cam0, too.
  const bool of_vins = has("num_of_cam") || has("image0_topic") || has("acc_n") || has("max_cnt");
  if (has("cam0_calib")) return {evidence::kCamera, Message{Code::kFoundTopLevel, {"cam0_calib"}}};
  if (of_vins && has("body_T_cam0")) return {evidence::kCamera, Message{Code::kFoundTopLevel, {"body_T_cam0"}}};
  if (has("model_type") && has("camera_name"))
    return {evidence::kPart, Message{Code::kFoundKeys, {std::vector<std::string>{"model_type", "camera_name"}}}};
  return {};
}

}  // namespace

const Format kFormat = {
    .id = "vins",
    .title = "VINS calibration (camodocal)",
    .syntaxes = "YAML",
    .extension = ".yaml",
    .program = "VINS-Fusion",
    .many_cameras = false,
    .extrinsics = false,
    .facts_apart = true,
    .imu = false,
    .noise_of_samples = true,
    .image_size = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .models = kModels,
    .probe = probe,
    .parts = camera_files_of,
    .read = read,
    .write = write,
};

}  // namespace fca::vins
