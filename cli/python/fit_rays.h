// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bindings.h"

#include <fca/convert/report.h>

#include <optional>

namespace fca::python {

/// A fitted camera, and how far it is from its source.
struct Fit {
  Camera camera;
  ConversionReport report;
};

/// To a Python function from pixels (N, 2) to rays (N, 3), over a lattice of the image; no number where it sees nothing.
[[nodiscard]] Fit fit_to_function(const py::function& rays_of, const ModelInfo& model, const Size& image_size,
                                  const std::optional<double>& max_angle_rad);
/// To rays (N, 3) and their pixels (N, 2), each of which counts alike.
[[nodiscard]] Fit fit_to_table(const Array& rays, const Array& pixels, const ModelInfo& model,
                               const std::optional<Size>& image_size, const std::optional<double>& max_angle_rad);

}  // namespace fca::python
