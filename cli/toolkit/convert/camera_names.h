// SPDX-License-Identifier: BSD-3-Clause
// The names of cameras in the written files, if they differ from those in the input.
#pragma once

#include <fca/formats/format.h>
#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// Sets ConvertedCamera::name_in_file to the cameras' names in the written files, if these contain names or number the cameras:
/// a chain begins with cam0, whichever camera that is.
void name_as_written(const Format& format, const Written& written, std::vector<ConvertedCamera>& cameras);

}  // namespace fca
