// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <fca/code.h>
#include <fca/toolkit/check.h>

#include <string>
#include <vector>

namespace fca::cli {

/// What `check` was asked for.
struct CheckArguments {
  CheckRequest request;
  std::vector<std::string> files;
  const CodeInfo* explain = nullptr;
  bool list_codes = false;
  bool fail_on_warnings = false;
  bool fix = false;
  bool write = false;
  bool json = false;
  bool sarif = false;
  bool verbose = false;
  bool quiet = false;
};

void add_check_options(Options& options, CheckArguments& arguments);

}  // namespace fca::cli
