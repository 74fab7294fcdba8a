// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include "scaramuzza.h"

#include <algorithm>
#include <array>

namespace fca::vins {

namespace {

constexpr std::string_view kMirror = "mirror_parameters";
constexpr std::string_view kDistortion = "distortion_parameters";
constexpr std::string_view kProjection = "projection_parameters";

constexpr std::array kPinhole = {Slot{kDistortion, "k1", "k1"}, Slot{kDistortion, "k2", "k2"}, Slot{kDistortion, "p1", "p1"},
                                 Slot{kDistortion, "p2", "p2"}, Slot{kProjection, "fx", "fx"}, Slot{kProjection, "fy", "fy"},
                                 Slot{kProjection, "cx", "cx"}, Slot{kProjection, "cy", "cy"}};
constexpr std::array kWithoutDistortion = {Slot{kDistortion, "k1", std::nullopt}, Slot{kDistortion, "k2", std::nullopt},
                                           Slot{kDistortion, "p1", std::nullopt}, Slot{kDistortion, "p2", std::nullopt},
                                           Slot{kProjection, "fx", "fx"},         Slot{kProjection, "fy", "fy"},
                                           Slot{kProjection, "cx", "cx"},         Slot{kProjection, "cy", "cy"}};
constexpr std::array kPinholeFull = {
    Slot{kDistortion, "k1", "k1"}, Slot{kDistortion, "k2", "k2"}, Slot{kDistortion, "k3", "k3"}, Slot{kDistortion, "k4", "k4"},
    Slot{kDistortion, "k5", "k5"}, Slot{kDistortion, "k6", "k6"}, Slot{kDistortion, "p1", "p1"}, Slot{kDistortion, "p2", "p2"},
    Slot{kProjection, "fx", "fx"}, Slot{kProjection, "fy", "fy"}, Slot{kProjection, "cx", "cx"}, Slot{kProjection, "cy", "cy"}};
constexpr std::array kMei = {
    Slot{kMirror, "xi", "xi"},         Slot{kDistortion, "k1", "k1"}, Slot{kDistortion, "k2", "k2"},
    Slot{kDistortion, "p1", "p1"},     Slot{kDistortion, "p2", "p2"}, Slot{kProjection, "gamma1", "fx"},
    Slot{kProjection, "gamma2", "fy"}, Slot{kProjection, "u0", "cx"}, Slot{kProjection, "v0", "cy"}};
constexpr std::array kKannalaBrandt = {
    Slot{kProjection, "k2", "k1"}, Slot{kProjection, "k3", "k2"}, Slot{kProjection, "k4", "k3"}, Slot{kProjection, "k5", "k4"},
    Slot{kProjection, "mu", "fx"}, Slot{kProjection, "mv", "fy"}, Slot{kProjection, "u0", "cx"}, Slot{kProjection, "v0", "cy"}};

constexpr std::array kLayouts = {Layout{"PINHOLE", "radtan", kPinhole}, Layout{"PINHOLE_FULL", "rational", kPinholeFull},
                                 Layout{"MEI", "mei", kMei}, Layout{"KANNALA_BRANDT", "kb4", kKannalaBrandt},
                                 Layout{kScaramuzza, "ocamcalib", {}},
                                 // Without distortion; such files are read so.
                                 Layout{"PINHOLE", "pinhole", kWithoutDistortion}};

}  // namespace

std::span<const Layout> layouts() { return kLayouts; }

const Layout* layout_of_type(std::string_view type) {
  const auto* const found = std::ranges::find(kLayouts, type, &Layout::type);
  return found == kLayouts.end() ? nullptr : found;
}

const Layout* layout_of_model(std::string_view model) {
  const auto* const found = std::ranges::find(kLayouts, model, &Layout::model);
  return found == kLayouts.end() ? nullptr : found;
}

std::vector<Section> sections_of(const Camera& camera, std::span<const double> inverse) {
  const Layout& layout = *layout_of_model(model_info(camera.model).id);
  if (layout.type == kScaramuzza) return scaramuzza_sections(camera.model, inverse);
  std::vector<Section> sections;
  for (const Slot& slot : layout.slots) {
    if (sections.empty() || sections.back().name != slot.section) sections.push_back({std::string(slot.section), {}});
    sections.back().fields.push_back(
        fields::real(std::string(slot.key), slot.parameter ? parameter(camera.model, *slot.parameter).value() : 0.0));
  }
  return sections;
}

std::vector<fields::Field> head_of(const Camera& camera, std::string_view name) {
  std::vector<fields::Field> head = {
      fields::scalar("model_type", std::string(layout_of_model(model_info(camera.model).id)->type)),
      fields::quoted("camera_name", name)};
  if (camera.image_size) {
    head.push_back(fields::integer("image_width", camera.image_size->width));
    head.push_back(fields::integer("image_height", camera.image_size->height));
  }
  return head;
}

}  // namespace fca::vins
