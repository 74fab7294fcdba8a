// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bindings.h"

#include <fca/toolkit/convert.h>

namespace fca::python {

/// What convert() was asked for.
struct AskedConversion {
  ConvertRequest request;
  std::optional<Image> weights;  ///< The image of WeightKind::kImage.
};

/// Raises TypeError and ValueError of what no request can be.
[[nodiscard]] AskedConversion asked_conversion(const py::object& source, const std::string& to, const py::kwargs& keywords);

}  // namespace fca::python
