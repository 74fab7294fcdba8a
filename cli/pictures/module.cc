// SPDX-License-Identifier: BSD-3-Clause
#include "module.h"
#include "images.h"
#include "opencv_maps.h"

#include <module_build.h>

#include <fca/toolkit/remap.h>

extern "C" __attribute__((visibility("default"))) const char* fca_module_build() { return fca::kModuleBuild; }

extern "C" __attribute__((visibility("default"))) const void* fca_picture_functions() {
  namespace module = fca::cli::module;
  static constexpr fca::cli::PictureFunctions kFunctions = {.decoded = &module::decoded_image,
                                                            .encoded = &module::encoded_image,
                                                            .remapped = &fca::remapped,
                                                            .map_file = &module::map_file,
                                                            .stereo_rectify = &fca::stereo_rectify};
  return &kFunctions;
}
