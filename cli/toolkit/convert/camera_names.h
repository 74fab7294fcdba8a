// SPDX-License-Identifier: BSD-3-Clause
// The names that cameras have in the written files, which may differ from their names in the input.
#pragma once

#include <fca/formats/format.h>
#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// Sets ConvertedCamera::name_in_file of each camera that has a name or a number in a written file. Example: the first camera
/// of a Kalibr camchain is always cam0. Does nothing for formats with one camera per file.
void name_as_written(const Format& format, const Written& written, std::vector<ConvertedCamera>& cameras);

}  // namespace fca
