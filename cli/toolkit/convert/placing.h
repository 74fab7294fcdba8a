// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Removes the files that the output has no place for (request.room), and sets the path of the others. False, with an error, if
/// such a file must not be left out, or the folder already holds the other form (text or binary) of one.
[[nodiscard]] bool place_files(const ConvertRequest& request, ConvertResult& result);

}  // namespace fca
