// SPDX-License-Identifier: BSD-3-Clause
// MASt3R-SLAM's intrinsics.yaml (rmurai0610/MASt3R-SLAM, mast3r_slam/dataloader.py). Read only: the program takes OpenCV's
// numbers in any file of these three keys.
//
//   width, height
//   calibration     [fx, fy, cx, cy, k1, k2, p1, p2, k3, ...]: what follows the first four is what cv::initUndistortRectifyMap
//                   takes, none, 4, 5, 8, 12 or 14 numbers, whatever the comment of the program's own file says
#include "mast3r.h"

#include "fields.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>

#include <algorithm>
#include <array>
#include <span>

namespace fca::mast3r {

using text::Node;

namespace {

constexpr text::Dialect kDialect = text::Dialect::kPyYaml;
constexpr std::array<ParameterId, 4> kFocalAndCentre = {"fx", "fy", "cx", "cy"};

std::optional<Camera> read_camera(const text::Document& document, std::vector<ExtraField>& kept, Diagnostics& diagnostics) {
  fields::Reader reader(document, kDialect, diagnostics);
  Camera camera;
  camera.name = "cam0";
  const Node& root = document.root();
  if (!root.is_mapping()) {
    diagnostics.add(Code::kTableWrongSyntax, {}, {document.source().name, 0, 0});
    return std::nullopt;
  }
  reader.warn_of_duplicates(root);
  const Node* width = reader.require(root, "width", camera.name);
  const Node* height = reader.require(root, "height", camera.name);
  const Node* list = reader.require(root, "calibration", camera.name);
  if (width == nullptr || height == nullptr || list == nullptr) return std::nullopt;
  camera.image_size = reader.image_size(*width, *height, "");
  const std::optional<std::vector<double>> numbers = reader.reals(*list, 0, "calibration");
  if (!camera.image_size || !numbers) return std::nullopt;
  const std::size_t count = std::max(numbers->size(), kFocalAndCentre.size()) - kFocalAndCentre.size();
  const bool is_opencvs = count == 0 || std::ranges::find(kOpenCvCounts, count) != kOpenCvCounts.end();
  if (!is_opencvs || numbers->size() < kFocalAndCentre.size()) {
    std::vector<std::string> counts = {std::to_string(kFocalAndCentre.size())};
    for (const std::size_t each : kOpenCvCounts) counts.push_back(std::to_string(kFocalAndCentre.size() + each));
    reader.say(*list, Code::kTableCoefficientCount, {"calibration", numbers->size(), counts, "it"});
    return std::nullopt;
  }
  camera.model = make_model(opencv_model_of(count)).value();
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    const ParameterId id =
        i < kFocalAndCentre.size() ? kFocalAndCentre.at(i) : kOpenCvCoefficients.at(i - kFocalAndCentre.size());
    if (!reader.parameter(list->items[i], "calibration", id, camera.model)) return std::nullopt;
  }
  reader.warn_of_misspelt();
  reader.keep_unasked(root, "", kept);
  return camera;
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& /*options*/, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    std::optional<Camera> camera = read_camera(document, rig.extra_fields, diagnostics);
    if (!camera) return std::nullopt;
    rig.cameras.push_back(*std::move(camera));
  }
  return rig;
}

ProbeResult probe(const text::Document& document) {
  const Node* list = text::find(document.root(), "calibration", kDialect);
  if (list == nullptr || !list->is_sequence()) return {};
  for (const char* side : {"width", "height"}) {
    if (text::find(document.root(), side, kDialect) != nullptr)
      return {evidence::kCamera, {Code::kFoundKeys, {std::vector<std::string>{"calibration", side}}}};
  }
  return {};
}

constexpr std::array kModels = {
    StoredModel{"radtan", "4 or 5 coefficients", true, "MASt3R-SLAM", {}},
    StoredModel{"rational", "8 coefficients", true, "MASt3R-SLAM", {}},
    StoredModel{"opencv14", "12 or 14 coefficients", true, "MASt3R-SLAM", {}},
    StoredModel{"pinhole", "no coefficients", true, "MASt3R-SLAM", {}},
};
constexpr std::array kOwnFacts = {OwnFact{"other keys"}};

}  // namespace

const Format kFormat = {
    .id = "mast3r",
    .title = "MASt3R-SLAM intrinsics",
    .syntaxes = "YAML",
    .extension = ".yaml",
    .program = "MASt3R-SLAM",
    .main_file = "intrinsics.yaml",
    .many_cameras = false,
    .extrinsics = false,
    .imu = false,
    .own_facts = kOwnFacts,
    .models = kModels,
    .probe = probe,
    .read = read,
};

}  // namespace fca::mast3r
