// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "shell/output_name.h"

#include <fca/toolkit/image.h>
#include <fca/toolkit/rectify.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fca::cli {

/// The files of maps: NumPy's, or cv::FileStorage's with the numbers that cv::remap takes (pictures.h).
enum class MapFormat : std::uint8_t { kNpy, kFloat, kFixedPoint };

/// What `rectify` was asked for.
struct RectifyArguments {
  RectifyRequest request;
  std::vector<std::string> left;  ///< Images: a file, a folder or a pattern; empty: none.
  std::vector<std::string> right;
  bool maps = false;  ///< Written, too.
  MapFormat map_format = MapFormat::kNpy;
  bool like_opencv = false;
  Interpolation interpolation = Interpolation::kBilinear;
  OutputPlace output;
  bool force = false;
  bool json = false;
};

void add_rectify_options(Options& options, RectifyArguments& arguments);

}  // namespace fca::cli
