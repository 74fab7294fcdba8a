// SPDX-License-Identifier: BSD-3-Clause
// mrcal's camera models: a .cameramodel file for each camera.
#pragma once

#include <fca/formats/format.h>

namespace fca::mrcal {

extern const Format kFormat;

}  // namespace fca::mrcal
