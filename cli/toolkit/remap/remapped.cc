// SPDX-License-Identifier: BSD-3-Clause
#include "image_mat.h"

#include <fca/toolkit/remap.h>

#include <exception>

#include <opencv2/imgproc.hpp>

namespace fca {

std::optional<Image> remapped(const Image& image, const ImageMap& map, Interpolation interpolation) {
  try {
    const cv::Mat places(map.size.height, map.size.width, CV_32FC2, const_cast<float*>(map.uv.data()));
    cv::Mat result;
    cv::remap(as_mat(image), result, places, cv::noArray(),
              interpolation == Interpolation::kLanczos ? cv::INTER_LANCZOS4 : cv::INTER_LINEAR);
    return as_image(result);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace fca
