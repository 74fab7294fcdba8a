// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <fca/toolkit/read.h>

namespace fca::cli {

/// What `show` was asked for.
struct ShowArguments {
  ReadRequest request;  ///< Its files: as typed.
  bool json = false;
};

void add_show_options(Options& options, ShowArguments& arguments);

}  // namespace fca::cli
