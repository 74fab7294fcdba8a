// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include "../column.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace fca::nerfstudio {

using text::Node;

namespace {

struct ModelName {
  std::string_view name;
  bool fisheye = false;
  bool bends = true;  ///< Its name promises coefficients. nerfstudio reads them in any case.
};

/// The first of a kind is written.
constexpr std::array kModelNames = {ModelName{"OPENCV"},
                                    ModelName{"OPENCV_FISHEYE", true},
                                    ModelName{"PINHOLE", false, false},
                                    ModelName{"SIMPLE_PINHOLE", false, false},
                                    ModelName{"SIMPLE_RADIAL"},
                                    ModelName{"RADIAL"}};

double per_unit(const AngleKey& key) { return key.degrees ? std::numbers::pi / 180.0 : 1.0; }

/// A number by its value, anything else by its text.
std::string shown(const Node& node) {
  const std::optional<double> value = node.is_scalar() ? text::parse_real(node.value) : std::nullopt;
  return value ? text::format_real(*value) : node.value;
}

/// What a frame says of its camera where the top does not; frames for which it is the same are of one camera.
std::string signature(const Node& root, const Node& frame) {
  std::string text;
  const auto add = [&](std::string_view key) {
    const Node* value = value_in(root, key) == nullptr ? value_in(frame, key) : nullptr;
    if (value != nullptr) text += std::string(key) + "=" + shown(*value) + ";";
  };
  for (const std::string_view key : kFocalAndCentre) add(key);
  for (const std::string_view key : kSize) add(key);
  for (const AngleKey& key : kAngles) {
    const std::string_view focal_length = key.horizontal ? kFocalAndCentre[0] : kFocalAndCentre[1];
    if (key.read && value_in(root, focal_length) == nullptr && value_in(frame, focal_length) == nullptr) add(key.name);
  }
  for (const std::string_view key : kCoefficients) {
    const Node* value = coefficients_at_top(root) ? nullptr : coefficient_in(frame, key);
    if (value != nullptr) text += std::string(key) + "=" + shown(*value) + ";";
  }
  return text;
}

std::string label_of(const Node& frame) {
  const Node* label = value_in(frame, kLabel);
  return label != nullptr && label->is_scalar() ? text::printable(label->value) : "";
}

/// By their labels if each has one of its own, else by their numbers.
void name_groups(std::vector<Group>& groups, const std::vector<std::string>& labels) {
  const std::set<std::string> different(labels.begin(), labels.end());
  const bool by_label = different.size() == groups.size() && !different.contains("");
  for (std::size_t i = 0; i < groups.size(); ++i) groups[i].name = by_label ? labels[i] : "cam" + std::to_string(i);
}

}  // namespace

double focal_length_of(const AngleKey& key, double angle, int side) {
  return 0.5 * side / std::tan(0.5 * angle * per_unit(key));
}

double angle_of(const AngleKey& key, double focal_length, int side) {
  return 2.0 * std::atan(0.5 * side / focal_length) / per_unit(key);
}

const AngleKey* angle_in(const Node& object, bool horizontal) {
  const auto* const found = std::ranges::find_if(kAngles, [&](const AngleKey& key) {
    return key.read && key.horizontal == horizontal && value_in(object, key.name) != nullptr;
  });
  return found == kAngles.end() ? nullptr : &*found;
}

const Node* value_in(const Node& object, std::string_view key) { return text::find(object, key, kDialect); }

bool is_coefficient(std::string_view key) { return std::ranges::find(kCoefficients, key) != kCoefficients.end(); }

const Node* coefficient_in(const Node& object, std::string_view key) {
  const Node* list = value_in(object, kCoefficientList);
  if (list == nullptr) return value_in(object, key);
  const auto place = static_cast<std::size_t>(std::ranges::find(kCoefficients, key) - kCoefficients.begin());
  return place < list->items.size() ? &list->items[place] : nullptr;
}

bool has_coefficients(const Node& object) {
  return value_in(object, kCoefficientList) != nullptr ||
         std::ranges::any_of(kCoefficients, [&object](std::string_view key) { return value_in(object, key) != nullptr; });
}

bool coefficients_at_top(const Node& root) {
  return value_in(root, kCoefficientList) != nullptr || std::ranges::any_of(kCoefficients, [&root](std::string_view key) {
           return key != "k4" && value_in(root, key) != nullptr;
         });
}

std::vector<Group> groups_of(const Node& root) {
  std::vector<Group> groups;
  std::vector<std::string> labels;
  std::vector<std::pair<std::string, std::string>> known;
  const Node* frames = value_in(root, kFrames);
  for (const Node& frame : frames != nullptr ? std::span<const Node>(frames->items) : std::span<const Node>()) {
    std::pair<std::string, std::string> camera = {signature(root, frame), ""};
    if (!camera.first.empty()) camera.second = label_of(frame);
    const auto found = std::ranges::find(known, camera);
    if (found == known.end()) {
      labels.push_back(camera.second);
      known.push_back(std::move(camera));
      groups.push_back({"", {&frame}});
    } else {
      groups[static_cast<std::size_t>(found - known.begin())].frames.push_back(&frame);
    }
  }
  if (groups.empty()) {
    groups.emplace_back();
    labels.emplace_back();
  }
  name_groups(groups, labels);
  return groups;
}

const Node& owner_of(const Node& root, const Group& group, std::string_view key) {
  const bool at_top = is_coefficient(key) ? coefficients_at_top(root) : value_in(root, key) != nullptr;
  return at_top || group.frames.empty() ? root : *group.frames.front();
}

bool is_fisheye(const Camera& camera) { return model_info(camera.model).id == "kb4"; }

std::optional<bool> is_fisheye_model(std::string_view camera_model) {
  const auto* const found = std::ranges::find(kModelNames, camera_model, &ModelName::name);
  return found == kModelNames.end() ? std::nullopt : std::optional(found->fisheye);
}

std::vector<std::string> read_models() { return column(kModelNames, &ModelName::name); }

std::string_view camera_model_for(std::string_view there, const CameraModel& model) {
  const std::string_view id = model_info(model).id;
  const bool fisheye = id == "kb4";
  const bool bends = id != "pinhole";
  const auto* const named = std::ranges::find(kModelNames, there, &ModelName::name);
  if (named != kModelNames.end() && named->fisheye == fisheye && (named->bends || !bends)) return named->name;
  const auto* const found =
      std::ranges::find_if(kModelNames, [&](const ModelName& each) { return each.fisheye == fisheye && each.bends == bends; });
  return found->name;
}

}  // namespace fca::nerfstudio
