// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include <fca/code.h>
#include <fca/formats/text/prose.h>

#include <algorithm>
#include <charconv>

namespace fca::kalibr {

const std::vector<Layout>& layouts() {
  static const std::vector<Slot> kFocalAndCentre = {{"fx"}, {"fy"}, {"cx"}, {"cy"}};
  static const std::vector<Layout> kLayouts = {
      {"radtan", "pinhole", "radtan", kFocalAndCentre, {{"k1"}, {"k2"}, {"p1"}, {"p2"}}},
      {"kb4", "pinhole", "equidistant", kFocalAndCentre, {{"k1"}, {"k2"}, {"k3"}, {"k4"}}},
      {"fov", "pinhole", "fov", kFocalAndCentre, {{"w"}}},
      // Written with four zeros: Kalibr reads pinhole-none, but its camera object then lacks a geometry (ConfigReader.py).
      {"pinhole", "pinhole", "radtan", kFocalAndCentre, {{0.0}, {0.0}, {0.0}, {0.0}}},
      {"pinhole", "pinhole", "none", kFocalAndCentre, {}},
      {"mei", "omni", "radtan", {{"xi"}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {{"k1"}, {"k2"}, {"p1"}, {"p2"}}},
      {"mei", "omni", "none", {{"xi"}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {}},
      {"eucm", "eucm", "none", {{"alpha"}, {"beta"}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {}},
      {"ds", "ds", "none", {{"xi"}, {"alpha"}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {}},
      {"ucm", "eucm", "none", {{"alpha"}, {1.0}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {}},
  };
  return kLayouts;
}

const Layout* layout_for(const CameraModel& model) {
  const auto& rows = layouts();
  const auto found = std::ranges::find(rows, model_info(model).id, &Layout::model);
  return found == rows.end() ? nullptr : &*found;
}

Message nearest_layout(const std::string& camera_model, const std::string& distortion_model) {
  const std::size_t cut = camera_model.find_first_of("/-");
  const std::string distortion = cut == std::string::npos ? distortion_model : camera_model.substr(cut + 1);
  const auto names = [](auto name_of, std::string_view camera) {
    std::vector<std::string> result;
    for (const Layout& layout : layouts()) {
      if (!camera.empty() && layout.camera_model != camera) continue;
      if (std::ranges::find(result, name_of(layout)) == result.end()) result.emplace_back(name_of(layout));
    }
    return result;
  };
  const std::vector<std::string> cameras =
      text::nearest(camera_model.substr(0, cut), names([](const Layout& each) { return each.camera_model; }, {}));
  if (cameras.empty()) return {};
  const std::vector<std::string> of_camera = names([](const Layout& each) { return each.distortion_model; }, cameras.front());
  const bool is_stated = std::ranges::find(of_camera, distortion_model) != of_camera.end();
  if (cut != std::string::npos && is_stated && distortion_model != "none") return Message{Code::kCamchainNearNames, {cameras}};
  const std::vector<std::string> distortions = text::nearest(distortion, of_camera);
  if (distortions.empty()) return cameras.front() == camera_model ? Message() : Message{Code::kCamchainNearNames, {cameras}};
  return {Code::kCamchainNearPair, {cameras.front(), distortions.front()}};
}

text::Dialect dialect_of(const text::Document& document) {
  return document.syntax() == text::Syntax::kOpenCvYaml ? text::Dialect::kOpenCv : text::Dialect::kPyYaml;
}

std::string indexed(std::string_view prefix, std::size_t index) { return std::string(prefix) + std::to_string(index); }

std::optional<std::size_t> index_in(std::string_view key, std::string_view prefix) {
  if (!key.starts_with(prefix) || key.size() == prefix.size()) return std::nullopt;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(key.data() + prefix.size(), key.data() + key.size(), index);
  if (error != std::errc() || end != key.data() + key.size()) return std::nullopt;
  return index;
}

}  // namespace fca::kalibr
