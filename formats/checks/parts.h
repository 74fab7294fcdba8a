// SPDX-License-Identifier: BSD-3-Clause
// Private: the files that a calibration names as parts of it (VINS-Fusion's configuration its camera files).
#pragma once

#include <fca/formats/check.h>

namespace fca::checks {

/// Adds which of them are missing, and what the document says otherwise than they; their own faults are theirs.
void check_parts(const text::Document& document, const Format& format, const CheckOptions& options, CheckReport& report);

}  // namespace fca::checks
