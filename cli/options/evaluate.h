// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "shell/output_name.h"

#include <string>

namespace fca::cli {

/// What `evaluate` was asked for.
struct EvaluateArguments {
  std::string image;  ///< A path; empty: tables without images.
  OutputPlace page;   ///< One file; empty: none.
  bool force = false;
  bool json = false;
};

void add_evaluate_options(Options& options, EvaluateArguments& arguments);

}  // namespace fca::cli
