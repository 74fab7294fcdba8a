// SPDX-License-Identifier: BSD-3-Clause
// Reports facts that a conversion assumed because files of the input's format never contain them.
#pragma once

#include <fca/formats/calibration.h>

namespace fca {

/// The translation T in OpenCV's stereo files has the unit of the calibration board's size, and no file contains that unit. If
/// such a pose is written to a format with a known unit, adds an entry to written.defaults which tells the user to check that
/// the translation is in metres. `to`: the format of the written files.
void list_assumed_units(const Calibration& calibration, const Format& to, Written& written);

}  // namespace fca
