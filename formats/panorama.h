// SPDX-License-Identifier: BSD-3-Clause
// Private: an image that shows all directions. No model here is its lens: it is read as a table of rays.
#pragma once

#include <fca/rig/rig.h>

namespace fca {

/// `camera`, which specifies its size, as a table of some 2,600 rays all over its equirectangular image: longitude atan2(x, z)
/// runs from -pi at column 0 to pi at column `width`, latitude from straight up at row 0 to straight down at row `height`, in
/// pixels whose first has its centre at (0, 0).
[[nodiscard]] Camera panorama(Camera camera);

}  // namespace fca
