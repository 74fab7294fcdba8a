// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/format.h>

namespace fca::okvis {

extern const Format kFormat;

}  // namespace fca::okvis
