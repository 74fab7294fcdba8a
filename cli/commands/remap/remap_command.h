// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"
#include "shell/output_name.h"

#include <fca/toolkit/remap.h>

#include <string>
#include <vector>

namespace fca::cli {

struct RemapArguments {
  RemapRequest request;
  std::string file;  ///< The calibration's.
  std::vector<std::string> images;
  Interpolation interpolation = Interpolation::kBilinear;
  OutputPlace output;
  std::string mask;
  std::string map;
  bool force = false;
  bool json = false;
  int views = 0;                       ///< How many of --model, --like and --pinhole were given; one is allowed.
  std::optional<ImageSize> view_size;  ///< --out-size
  bool equirectangular = false;
};

void add_remap_command(Application& application);

}  // namespace fca::cli
