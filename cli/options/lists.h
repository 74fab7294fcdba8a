// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <fca/toolkit/inputs.h>

namespace fca::cli {

/// What `formats`, `models`, `programs` or `version` was asked for.
struct ListArguments {
  Inputs inputs;  ///< Of `models FILE`; no file: all models are listed.
  bool json = false;
  bool markdown = false;
  bool ledger = false;
  bool verbose = false;
};

void add_formats_options(Options& options, ListArguments& arguments);
void add_models_options(Options& options, ListArguments& arguments);
void add_programs_options(Options& options, ListArguments& arguments);
void add_version_options(Options& options, ListArguments& arguments);

}  // namespace fca::cli
