// SPDX-License-Identifier: BSD-3-Clause
// Kimera-VIO: LeftCameraParams.yaml, RightCameraParams.yaml and ImuParams.yaml of a folder of parameters.
#pragma once

#include <fca/formats/format.h>

namespace fca::kimera {

extern const Format kFormat;

}  // namespace fca::kimera
