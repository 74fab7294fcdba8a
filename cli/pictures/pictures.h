// SPDX-License-Identifier: BSD-3-Clause
// What needs OpenCV's image modules. Loading those takes longer than a conversion, so that they are in a module of their own,
// which is loaded when a picture is asked for; these functions are its door.
#pragma once

#include "toolkit/rectify/stereo_rectify.h"

#include <fca/toolkit/image.h>

#include <fca/remap/image_map.h>

#include <cstdint>
#include <optional>
#include <string>

namespace fca::cli {

// All throw consumers::MissingModule where the installation lacks the module.

/// The image in a file's bytes; nothing where that is none, not a whole one, or one of a kind that Image does not hold. As it
/// is stored: an orientation that a camera has noted next to it turns nothing.
[[nodiscard]] std::optional<Image> decoded(const std::string& bytes);
/// The bytes of a file; `extension` with its point. Nothing where that cannot be made.
[[nodiscard]] std::optional<std::string> encoded(const Image& image, const std::string& extension);
/// cv::remap: the image through a map, 0 where the map lies outside of it. Sides are to be shorter than 32,767.
[[nodiscard]] std::optional<Image> remapped(const Image& image, const ImageMap& map, Interpolation interpolation);

/// How cv::remap takes a map: CV_32FC1, u and v; or CV_16SC2 with CV_16UC1, which is faster and rounds to 1/32 px.
enum class MapNumbers : std::uint8_t { kFloat, kFixedPoint };
/// A file of cv::FileStorage with the matrices map1 and map2; `compressed`: as a .yml.gz. Nothing where that cannot be made.
[[nodiscard]] std::optional<std::string> map_file(const ImageMap& map, MapNumbers numbers, bool compressed);

/// cv::stereoRectify, or cv::fisheye's.
[[nodiscard]] std::optional<OpenCvRectification> stereo_rectified(const OpenCvPair& pair);

}  // namespace fca::cli
