// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/format.h>

namespace fca::mast3r {

extern const Format kFormat;

}  // namespace fca::mast3r
