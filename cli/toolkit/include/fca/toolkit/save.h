// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// What a file is called in the folder: its name without others, or its place in a folder of its program's own.
[[nodiscard]] std::string name_in_folder(const ConvertedFile& file);

/// Writes the files of a result that is kDone into a folder, which is made if it is not there, under their names. A file is
/// whole or not there. False with an error where that fails, the result is another, or one of the files exists and may not be
/// replaced: then none is written.
[[nodiscard]] bool save(const ConvertResult& result, const std::string& folder, Diagnostics& diagnostics,
                        bool replaces = false);

}  // namespace fca
