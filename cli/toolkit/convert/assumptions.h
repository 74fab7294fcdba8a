// SPDX-License-Identifier: BSD-3-Clause
// Assumptions about facts that the files of a format never contain.
#pragma once

#include <fca/formats/calibration.h>

namespace fca {

/// The translation T of OpenCV's stereo files is in the unit of the calibration board, which no file contains. If such a pose
/// is written to another format, adds to written.defaults that metres were assumed, so that the user can check it.
void list_assumed_units(const Calibration& calibration, const Format& to, Written& written);

}  // namespace fca
