// SPDX-License-Identifier: BSD-3-Clause
// What the files written call the cameras, where that is not what the input calls them.
#pragma once

#include <fca/formats/format.h>
#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// Gives the cameras the names that the files written have for them, where those state or count cameras: a chain begins with
/// cam0, whichever camera was chosen for it.
void name_as_written(const Format& format, const Written& written, std::vector<ConvertedCamera>& cameras);

}  // namespace fca
