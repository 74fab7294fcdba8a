// SPDX-License-Identifier: BSD-3-Clause
// One way to write what was read: a model, a mode, a layout.
#pragma once

#include "start.h"

namespace fca {

/// Fits, writes in memory, places and proves it, into the result; false with errors.
[[nodiscard]] bool write_as_asked(const ConvertRequest& request, const Start& start, ConvertResult& result);

}  // namespace fca
