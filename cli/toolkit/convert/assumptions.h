// SPDX-License-Identifier: BSD-3-Clause
// What is taken for granted because no file of a format says it.
#pragma once

#include <fca/formats/calibration.h>

namespace fca {

/// OpenCV's T is in the unit of the calibration board, which no file states: where such a pose goes into another format, that
/// it is in metres is an assumption to look at.
void list_assumed_units(const Calibration& calibration, const Format& to, Written& written);

}  // namespace fca
