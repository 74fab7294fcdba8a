// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace fca::internal {

/// Row-major.
using Matrix3 = std::array<double, 9>;

}  // namespace fca::internal
