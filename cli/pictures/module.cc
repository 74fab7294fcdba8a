// SPDX-License-Identifier: BSD-3-Clause
#include "module.h"
#include "images.h"

#include <fca/toolkit/remap.h>

#include <opencv2/imgcodecs.hpp>

namespace {

std::string png_bytes(const fca::cli::Picture& picture) {
  // OpenCV's order is blue, green, red.
  cv::Mat4b rows(picture.height, picture.width);
  auto from = picture.rgba.begin();
  for (cv::Vec4b& pixel : rows) {
    pixel = {from[2], from[1], from[0], from[3]};
    from += 4;
  }
  constexpr int kLevel = 6;  // zlib's own choice; 9 makes a page a fifth smaller in four times the time
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", rows, bytes, {cv::IMWRITE_PNG_COMPRESSION, kLevel});
  return {bytes.begin(), bytes.end()};
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const void* fca_picture_functions() {
  namespace module = fca::cli::module;
  static constexpr fca::cli::PictureFunctions kFunctions = {
      .png = &png_bytes, .decoded = &module::decoded_image, .encoded = &module::encoded_image, .remapped = &fca::remapped};
  return &kFunctions;
}
