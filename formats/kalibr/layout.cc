// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

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
