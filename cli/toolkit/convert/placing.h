// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Removes the files that the output cannot take (request.room) and sets the paths of the others (request.path_of). Also
/// removes fillers whose path exists on the disk. Returns false, with an error, if a file that must not be left out cannot be
/// taken, or if the folder on the disk already has the other form (text or binary) of a file.
[[nodiscard]] bool place_files(const ConvertRequest& request, ConvertResult& result);

}  // namespace fca
