// SPDX-License-Identifier: BSD-3-Clause
// Private: what several programs' ways from pixel to ray have in common.
#pragma once

#include <string_view>

namespace fca::consumers {

/// ORB-SLAM3's KannalaBrandt8::unproject and cv::fisheye::undistortPoints: the distorted angle is cut off at pi / 2, and a ray
/// is K (x / z, y / z).
inline constexpr std::string_view kUpToNinety =
    "from pixel to ray it goes no further than 90 deg, of the ray and of the distorted angle";

}  // namespace fca::consumers
