// SPDX-License-Identifier: BSD-3-Clause
// Private: translations in another unit.
#pragma once

#include <fca/rig/rig.h>

#include <cstddef>

namespace fca {

/// The last column of the matrix times `factor`.
inline void scale_translation(double factor, Transform& T) {
  constexpr int kTranslation = 3;
  for (int row = 0; row < 3; ++row) T.values.at(static_cast<std::size_t>(4 * row + kTranslation)) *= factor;
}

}  // namespace fca
