// SPDX-License-Identifier: BSD-3-Clause
// Private: the functions of pictures.h, as the module and its loader see them.
#pragma once

#include "pictures.h"

namespace fca::cli {

struct PictureFunctions {
  std::optional<Image> (*decoded)(const std::string& bytes);
  std::optional<std::string> (*encoded)(const Image& image, const std::string& extension);
  std::optional<Image> (*remapped)(const Image& image, const ImageMap& map, Interpolation interpolation);
  std::optional<std::string> (*map_file)(const ImageMap& map, MapNumbers numbers, bool compressed);
  std::optional<OpenCvRectification> (*stereo_rectify)(const OpenCvPair& pair);
};

/// What the module exports: a function without arguments that returns a pointer to its PictureFunctions.
inline constexpr const char* kPictureFunctions = "fca_picture_functions";

}  // namespace fca::cli
