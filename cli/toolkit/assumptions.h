// SPDX-License-Identifier: BSD-3-Clause
// What is taken for granted because no file of a format says it.
#pragma once

#include <fca/formats/calibration.h>

namespace fca::cli {

/// OpenCV's T is in the unit of the calibration board, which no file states: where such a pose goes into another format, that
/// it is in metres is an assumption to look at.
void list_assumed_units(const Calibration& calibration, const Format& to, Written& written);

/// Does a file of such a format state the pose?
[[nodiscard]] bool has_assumed_unit(const PoseEdge& edge, const Calibration& calibration);

}  // namespace fca::cli
