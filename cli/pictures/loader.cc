// SPDX-License-Identifier: BSD-3-Clause
#include "module.h"

#include <fca/code.h>
#include <fca/formats/consumers/load_module.h>

#include <cstdlib>

namespace fca::cli {

namespace {

const PictureFunctions* load() {
  // OpenCV asks for its limit when it is loaded.
  ::setenv("OPENCV_IO_MAX_IMAGE_PIXELS", std::to_string(kMostPixels).c_str(), 0);
  return static_cast<const PictureFunctions*>(
      consumers::load_module(FCA_PICTURES_MODULE, kPictureFunctions, Message{Code::kModuleOfPictures}));
}

const PictureFunctions& functions() {
  static const PictureFunctions* const kLoaded = load();
  return *kLoaded;
}

}  // namespace

std::optional<Image> decoded(const std::string& bytes) { return functions().decoded(bytes); }

std::optional<std::string> encoded(const Image& image, const std::string& extension) {
  return functions().encoded(image, extension);
}

std::optional<Image> remapped(const Image& image, const ImageMap& map, Interpolation interpolation) {
  return functions().remapped(image, map, interpolation);
}

std::optional<std::string> map_file(const ImageMap& map, MapNumbers numbers, bool compressed) {
  return functions().map_file(map, numbers, compressed);
}

std::optional<OpenCvRectification> stereo_rectified(const OpenCvPair& pair) { return functions().stereo_rectify(pair); }

}  // namespace fca::cli
