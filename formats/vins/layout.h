// SPDX-License-Identifier: BSD-3-Clause
// How camodocal's names and ours map onto each other.
#pragma once

#include "../fields.h"

#include <fca/formats/text/dialect.h>
#include <fca/rig/rig.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::vins {

inline constexpr text::Dialect kDialect = text::Dialect::kOpenCv;

/// A number in a camera file.
struct Slot {
  constexpr Slot(std::string_view of, std::string_view name, ParameterId id) : section(of), key(name), parameter(id) {}
  constexpr Slot(std::string_view of, std::string_view name, std::nullopt_t) : section(of), key(name) {}
  std::string_view section;
  std::string_view key;
  std::optional<ParameterId> parameter;  ///< Of our model; nothing: 0.
};

/// What a file of one model_type holds, in camodocal's order. Those of scaramuzza are computed (scaramuzza.h): no slots.
struct Layout {
  std::string_view type;
  std::string_view model;
  std::span<const Slot> slots;
};

[[nodiscard]] std::span<const Layout> layouts();
/// By model_type, exactly as camodocal compares it; null if there is none.
[[nodiscard]] const Layout* layout_of_type(std::string_view type);
/// By our model; null if there is none.
[[nodiscard]] const Layout* layout_of_model(std::string_view model);

inline constexpr std::string_view kScaramuzza = "scaramuzza";

/// A mapping at the top of the file and its numbers.
struct Section {
  std::string name;
  std::vector<fields::Field> fields;
  bool operator==(const Section&) const = default;
};

/// What a file says of the camera's lens, section by section, in camodocal's order. `inverse`: of scaramuzza, OCamCalib's
/// inverse polynomial.
[[nodiscard]] std::vector<Section> sections_of(const Camera& camera, std::span<const double> inverse);

/// model_type, camera_name and the size.
[[nodiscard]] std::vector<fields::Field> head_of(const Camera& camera, std::string_view name);

/// The name that camodocal's own files have for any camera.
inline constexpr std::string_view kNameless = "camera";

}  // namespace fca::vins
