// SPDX-License-Identifier: BSD-3-Clause
// Numbers of an opencv-matrix (or of a plain list, as some write vectors) with their places.
#pragma once

#include "../fields.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::opencv {

/// Numbers of a matrix or list, with their places.
struct Numbers {
  int rows = 0;
  int cols = 0;
  bool is_float = false;  ///< dt: f; OpenCV holds floats.
  std::vector<double> values;
  std::vector<const text::Node*> nodes;
  [[nodiscard]] bool is_vector() const { return rows <= 1 || cols <= 1; }
};

/// Nothing, with an error, where neither a matrix of floating-point numbers nor a list of numbers stands.
[[nodiscard]] std::optional<Numbers> read_numbers(const text::Node& node, const std::string& what, fields::Reader& reader);

/// Sets a parameter of the model to the number at `place`; an error there if that cannot be.
[[nodiscard]] bool set(const Numbers& from, std::size_t place, const std::string& what, ParameterId id, CameraModel& model,
                       fields::Reader& reader);

}  // namespace fca::opencv
