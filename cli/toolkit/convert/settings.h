// SPDX-License-Identifier: BSD-3-Clause
// Values of the written file that no calibration states.
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Writes each setting into every written file that has its key, and takes it off the list of defaults; false with an error.
[[nodiscard]] bool apply_settings(const ConvertRequest& request, const Format& format, Written& written,
                                  Diagnostics& diagnostics);

}  // namespace fca
