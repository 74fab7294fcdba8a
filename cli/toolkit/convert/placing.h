// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Sets the paths of the result's files. If the request does not allow so many files, files without cameras are removed and
/// listed as losses; anything else is an error. False with errors.
[[nodiscard]] bool place_files(const ConvertRequest& request, ConvertResult& result);

}  // namespace fca
