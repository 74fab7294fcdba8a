// SPDX-License-Identifier: BSD-3-Clause
// R1 R2 P1 P2 Q of a pair, as cv::stereoRectify returns them and OpenCV's sample stereo_calib.cpp stores them.
#pragma once

#include "../fields.h"

#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace fca::opencv {

/// Q follows from the others.
inline constexpr std::array<std::string_view, 5> kRectificationKeys = {"R1", "R2", "P1", "P2", "Q"};

/// Of cam0 and cam1; nothing where one of the first four is not there, or they are no rectification.
[[nodiscard]] std::optional<RectifiedPair> read_rectification(const text::Document& document);

/// All five. The pair's first camera is the file's.
[[nodiscard]] std::vector<fields::Field> rectification_fields(const RectifiedPair& pair);

}  // namespace fca::opencv
