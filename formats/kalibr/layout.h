// SPDX-License-Identifier: BSD-3-Clause
// Which lists hold what, per camera_model and distortion_model; and how cameras are named.
#pragma once

#include <fca/formats/text/dialect.h>
#include <fca/formats/text/document.h>
#include <fca/message.h>
#include <fca/models/camera_model.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::kalibr {

/// One number of intrinsics or distortion_coeffs: a parameter of our model, or a constant the layout demands.
struct Slot {
  // NOLINTBEGIN(google-explicit-constructor): {"fx", "fy", 0.0} is a row.
  constexpr Slot(ParameterId id) : parameter(id) {}
  constexpr Slot(double value) : constant(value) {}
  // NOLINTEND(google-explicit-constructor)
  std::optional<ParameterId> parameter;
  double constant = 0.0;
};

/// How Kalibr writes one of our models.
struct Layout {
  std::string_view model;
  std::string_view camera_model;
  std::string_view distortion_model;
  std::vector<Slot> intrinsics;
  std::vector<Slot> coefficients;
};

/// Reading takes the first row with the file's two names, writing the first row of the model.
[[nodiscard]] const std::vector<Layout>& layouts();

/// The row for writing; null if Kalibr has no such model.
[[nodiscard]] const Layout* layout_for(const CameraModel& model);

/// "did you mean ...?", where the two names of a camera are near those of a row; a camera_model may hold both
/// ("pinhole/radtan"). Else says nothing.
[[nodiscard]] Message nearest_layout(const std::string& camera_model, const std::string& distortion_model);

/// OpenVINS' chains are OpenCV's YAML, Kalibr's own are PyYAML's.
[[nodiscard]] text::Dialect dialect_of(const text::Document& document);

/// "cam" and 12 -> "cam12".
[[nodiscard]] std::string indexed(std::string_view prefix, std::size_t index);
/// "cam12" and "cam" -> 12.
[[nodiscard]] std::optional<std::size_t> index_in(std::string_view key, std::string_view prefix);

}  // namespace fca::kalibr
