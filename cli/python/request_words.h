// SPDX-License-Identifier: BSD-3-Clause
// Words of requests that several functions take.
#pragma once

#include "keywords.h"

#include <fca/toolkit/convert.h>
#include <fca/toolkit/target.h>

namespace fca::python {

/// Raises ValueError for a name of no format or program that is written.
[[nodiscard]] Target target_named(const std::string& name);

/// Paths of further parts of the calibration.
void take_parts(const Value& value, Inputs& inputs);
/// Degrees from the axis.
void take_max_angle(const Value& value, Inputs& inputs);
/// Names, or places from 0: one or several.
void take_cameras(const Value& value, Inputs& inputs);
/// {"k3": 0.0, "cx": None, "fx": "fy"}
void take_fixed(const Value& value, ConvertRequest& request);

}  // namespace fca::python
