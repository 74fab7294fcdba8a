// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <fca/toolkit/inputs.h>

#include <string>

namespace fca::cli {

/// What `project` or `unproject` was asked for.
struct ProjectArguments {
  Inputs inputs;
  bool json = false;
};

/// The same for both; the example is not.
void add_project_options(Options& options, const std::string& footer, ProjectArguments& arguments);

}  // namespace fca::cli
