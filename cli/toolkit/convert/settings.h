// SPDX-License-Identifier: BSD-3-Clause
// Sets values of the written files that are no part of the calibration: `--set ORBextractor.nFeatures=2000`.
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Sets the value of each setting in every file that has its key. If no file has the key, adds it to the files to which the
/// format allows it to be added. Removes the key from written.defaults, since its value is now the user's. `format`: the format
/// of the written files. Returns false, with an error, if no file takes a key, or if a value is wrong or contradicts the
/// calibration.
[[nodiscard]] bool apply_settings(const ConvertRequest& request, const Format& format, Written& written,
                                  Diagnostics& diagnostics);

}  // namespace fca
