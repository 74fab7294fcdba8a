// SPDX-License-Identifier: BSD-3-Clause
#include "module.h"
#include "images.h"
#include "opencv_maps.h"

#include <module_build.h>

#include <fca/toolkit/remap.h>

#include <opencv2/imgcodecs.hpp>

namespace {

/// OpenCV's order is blue, green, red.
template <class Pixel>
std::vector<std::uint8_t> png_of(const fca::cli::Picture& picture) {
  cv::Mat_<Pixel> rows(picture.height, picture.width);
  auto from = picture.rgba.begin();
  for (Pixel& pixel : rows) {
    pixel[0] = from[2];
    pixel[1] = from[1];
    pixel[2] = from[0];
    if constexpr (Pixel::channels == 4) pixel[3] = from[3];
    from += 4;
  }
  constexpr int kLevel = 4;  // 6 makes a page a seventh smaller in twice the time
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", rows, bytes, {cv::IMWRITE_PNG_COMPRESSION, kLevel});
  return bytes;
}

bool is_opaque(const fca::cli::Picture& picture) {
  constexpr std::uint8_t kOpaque = 0xFF;
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
    if (picture.rgba[i] != kOpaque) return false;
  }
  return true;
}

std::string png_bytes(const fca::cli::Picture& picture) {
  const std::vector<std::uint8_t> bytes = is_opaque(picture) ? png_of<cv::Vec3b>(picture) : png_of<cv::Vec4b>(picture);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const char* fca_module_build() { return fca::kModuleBuild; }

extern "C" __attribute__((visibility("default"))) const void* fca_picture_functions() {
  namespace module = fca::cli::module;
  static constexpr fca::cli::PictureFunctions kFunctions = {.png = &png_bytes,
                                                            .decoded = &module::decoded_image,
                                                            .encoded = &module::encoded_image,
                                                            .remapped = &fca::remapped,
                                                            .map_file = &module::map_file,
                                                            .stereo_rectify = &fca::stereo_rectify};
  return &kFunctions;
}
