// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace fca {

inline constexpr double kDegreesPerRadian = 57.29577951308232;

}  // namespace fca
