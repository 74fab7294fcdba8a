// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <fca/toolkit/compare.h>

#include <string>

namespace fca::cli {

/// What `compare` was asked for.
struct CompareArguments {
  CompareRequest request;
  std::string page;  ///< --report
  bool force = false;
  bool json = false;
  bool verbose = false;
};

void add_compare_options(Options& options, CompareArguments& arguments);

}  // namespace fca::cli
