// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Gives the result's files their paths. Those that there is no room for are left out, with a loss, or are an error, and then
/// it is false.
[[nodiscard]] bool place_files(const ConvertRequest& request, ConvertResult& result);

}  // namespace fca
