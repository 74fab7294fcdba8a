// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <fca/toolkit/programs.h>

#include <string>

namespace fca::cli {

/// --for PROGRAM
void add_program_option(Options& options, const std::string& help, const consumers::Consumer*& target);

}  // namespace fca::cli
