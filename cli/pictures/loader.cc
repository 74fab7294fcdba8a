// SPDX-License-Identifier: BSD-3-Clause
#include "module.h"

#include <fca/formats/consumers/load_module.h>

namespace fca::cli {

namespace {

const PictureFunctions& functions() {
  static const auto* kLoaded = static_cast<const PictureFunctions*>(
      consumers::load_module(FCA_PICTURES_MODULE, kPictureFunctions, "which makes pictures"));
  return *kLoaded;
}

}  // namespace

std::string png(const Picture& picture) { return functions().png(picture); }

std::optional<Image> decoded(const std::string& bytes) { return functions().decoded(bytes); }

std::optional<std::string> encoded(const Image& image, const std::string& extension) {
  return functions().encoded(image, extension);
}

std::optional<Image> remapped(const Image& image, const ImageMap& map, Interpolation interpolation) {
  return functions().remapped(image, map, interpolation);
}

}  // namespace fca::cli
