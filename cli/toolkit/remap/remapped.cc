// SPDX-License-Identifier: BSD-3-Clause
#include "image_mat.h"

#include <fca/toolkit/remap.h>

#include <algorithm>
#include <exception>

#include <opencv2/imgproc.hpp>

namespace fca {

std::optional<Image> remapped(const Image& image, const ImageMap& map, Interpolation interpolation) {
  try {
    const cv::Mat positions(map.size.height, map.size.width, CV_32FC2, const_cast<float*>(map.uv.data()));
    const cv::Mat source = as_mat(image);
    cv::Mat result(positions.size(), source.type());
    const int method = interpolation == Interpolation::kLanczos ? cv::INTER_LANCZOS4 : cv::INTER_LINEAR;
    // For more than 2^16 pixels, OpenCV starts threads, and it ends the program if it cannot start them. So the image is
    // remapped in
    // bands of rows.
    constexpr int kMostPixelsOfOneThread = 1 << 16;
    const int rows = std::max(1, kMostPixelsOfOneThread / positions.cols);
    for (int first = 0; first < positions.rows; first += rows) {
      const cv::Range band(first, std::min(positions.rows, first + rows));
      cv::Mat part = result.rowRange(band);
      cv::remap(source, part, positions.rowRange(band), cv::noArray(), method);
    }
    return as_image(result);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace fca
