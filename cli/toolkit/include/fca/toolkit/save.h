// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// The path of a file relative to the output folder: ConvertedFile::place if it is set, otherwise the file's name.
[[nodiscard]] std::string name_in_folder(const ConvertedFile& file);

/// Writes the files of a result into a folder, and creates the folder if it does not exist. A file is never written in part.
/// `replaces`: existing files may be replaced. False, with an error, if writing fails, if the result's status is not kDone, or
/// if a file exists and may not be replaced. In the last two cases no file is written.
[[nodiscard]] bool save(const ConvertResult& result, const std::string& folder, Diagnostics& diagnostics,
                        bool replaces = false);

}  // namespace fca
