// SPDX-License-Identifier: BSD-3-Clause
// Values that the user gives for keys of the written file which are not calibration: `--set ORBextractor.nFeatures=2000`.
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Sets each of request.settings in every file of `written` that has its key, and removes the key from written.defaults, since
/// it is no default any more. `format` is the files' format: it says which keys may be added. False, with an error, if no file
/// takes a key, or the value is wrong or contradicts the calibration.
[[nodiscard]] bool apply_settings(const ConvertRequest& request, const Format& format, Written& written,
                                  Diagnostics& diagnostics);

}  // namespace fca
