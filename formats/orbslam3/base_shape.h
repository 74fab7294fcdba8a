// SPDX-License-Identifier: BSD-3-Clause
// Matrices of a settings file that is edited keep its way of writing them.
#pragma once

#include "../fields.h"

#include <vector>

namespace fca::orbslam3 {

/// The same fields with the base's dt, columns and length: LEFT.D as a column of four floats, Tlr with its last row. Where the
/// base's matrix has no room for a number, the field is left as it is.
[[nodiscard]] std::vector<fields::Field> shaped_as(std::vector<fields::Field> fields, const text::Document& base);

}  // namespace fca::orbslam3
