// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/format.h>

namespace fca::fast_livo {

extern const Format kFormat;

}  // namespace fca::fast_livo
