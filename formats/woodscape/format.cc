// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "woodscape.h"

#include <fca/code.h>
#include <fca/formats/text/dialect.h>

#include <array>

namespace fca::woodscape {

using text::Node;

namespace {

/// Below, k1 cannot be pixels per radian: the reader refuses it, and so no camera may be written with one.
constexpr std::array kInPixels = {ParameterRange{"k1", 10.0, 1e9}};
constexpr std::array kModels = {
    StoredModel{"woodscape", "radial_poly", true, "WoodScape's projection.py", kInPixels, Code::kWoodscapeJsonInPixels}};
constexpr std::array kOwnFacts = {OwnFact{"keys of its own"}};
constexpr std::array kDemands = {Demand{"pose in the vehicle", "extrinsic"}};

ProbeResult probe(const text::Document& document) {
  constexpr text::Dialect kDialect = text::Dialect::kPyYaml;
  const Node& root = document.root();
  if (!root.is_mapping()) return {};
  const Node* intrinsic = text::find(root, "intrinsic", kDialect);
  if (intrinsic == nullptr || !intrinsic->is_mapping()) return {};
  const Node* model = text::find(*intrinsic, "model", kDialect);
  if (model != nullptr && model->value == "radial_poly")
    return {evidence::kCamera, Message{Code::kWoodscapeJsonWithKey, {"model \"radial_poly\""}}};
  for (const std::string_view key : {"cx_offset", "cy_offset", "poly_order"}) {
    if (text::find(*intrinsic, key, kDialect) != nullptr) return {evidence::kPart, Message{Code::kWoodscapeJsonWithKey, {key}}};
  }
  const Node* extrinsic = text::find(root, "extrinsic", kDialect);
  if (extrinsic != nullptr && extrinsic->is_mapping() && text::find(*extrinsic, "quaternion", kDialect) != nullptr &&
      text::find(*intrinsic, "k1", kDialect) != nullptr)
    return {evidence::kHint, Message{Code::kWoodscapeJsonWithQuaternion}};
  return {};
}

}  // namespace

const Format kFormat = {
    .id = "woodscape",
    .title = "WoodScape JSON",
    .syntaxes = "JSON",
    .extension = ".json",
    .program = "WoodScape",
    .many_cameras = false,
    .extrinsics = true,
    .imu = false,
    .image_size = true,
    .frame = "vehicle",
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .models = kModels,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::woodscape
