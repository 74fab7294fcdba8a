// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "shell/output_name.h"

#include <fca/toolkit/remap.h>

#include <string>
#include <vector>

namespace fca::cli {

/// What `remap` was asked for.
struct RemapArguments {
  RemapRequest request;
  std::vector<std::string> images;
  Interpolation interpolation = Interpolation::kBilinear;
  OutputPlace output;
  std::string mask;  ///< Paths; empty: none.
  std::string map;
  bool force = false;
  bool json = false;
};

/// --interpolation
void add_interpolation_option(Options& options, Interpolation& target);

void add_remap_options(Options& options, RemapArguments& arguments);

}  // namespace fca::cli
