// SPDX-License-Identifier: BSD-3-Clause
// --set KEY=VALUE
#pragma once

#include "conversion.h"

namespace fca::cli {

/// Writes each setting into every written file that has its key, and takes it off the list of defaults; false with an error.
[[nodiscard]] bool apply_settings(const ConvertArguments& arguments, const Format& format, Written& written,
                                  Diagnostics& diagnostics);

}  // namespace fca::cli
