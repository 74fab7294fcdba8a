// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's cameras.txt: a line for each camera, CAMERA_ID MODEL WIDTH HEIGHT PARAMS[] (colmap@5d968cf, sensor/models.h and
// scene/reconstruction_io_text.cc). Its pixels are half a pixel larger than ours: the centre of the first one is (0.5, 0.5).
#pragma once

#include <fca/formats/format.h>

namespace fca::colmap {

extern const Format kFormat;

}  // namespace fca::colmap
