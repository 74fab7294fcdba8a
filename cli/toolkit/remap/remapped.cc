// SPDX-License-Identifier: BSD-3-Clause
#include "image_mat.h"

#include <fca/toolkit/remap.h>

#include <algorithm>
#include <exception>

#include <opencv2/imgproc.hpp>

namespace fca {

std::optional<Image> remapped(const Image& image, const ImageMap& map, Interpolation interpolation) {
  try {
    const cv::Mat places(map.size.height, map.size.width, CV_32FC2, const_cast<float*>(map.uv.data()));
    const cv::Mat source = as_mat(image);
    cv::Mat result(places.size(), source.type());
    const int how = interpolation == Interpolation::kLanczos ? cv::INTER_LANCZOS4 : cv::INTER_LINEAR;
    // OpenCV starts threads for more than 2^16 pixels, and ends the program if it cannot.
    constexpr int kMostPixelsOfOneThread = 1 << 16;
    const int rows = std::max(1, kMostPixelsOfOneThread / places.cols);
    for (int first = 0; first < places.rows; first += rows) {
      const cv::Range band(first, std::min(places.rows, first + rows));
      cv::Mat part = result.rowRange(band);
      cv::remap(source, part, places.rowRange(band), cv::noArray(), how);
    }
    return as_image(result);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace fca
