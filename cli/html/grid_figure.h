// SPDX-License-Identifier: BSD-3-Clause
// A grid over an image, and where a program sees its lines.
#pragma once

#include "html.h"

#include <fca/formats/pixel_distance.h>
#include <fca/rig/rig.h>

#include <string>

namespace fca::cli {

/// The lines of the grid before (straight) and after (as the program sees them, differences enlarged where they are small), as
/// a tile. Nothing is drawn where nothing was compared.
void put_grid(Html& html, const std::string& camera, const std::string& program, const CameraDistance& distance);

}  // namespace fca::cli
