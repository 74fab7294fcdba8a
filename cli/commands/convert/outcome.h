// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/convert.h"
#include "shell/exit_code.h"

#include <fca/toolkit/convert.h>

#include <string>
#include <vector>

namespace fca::cli {

/// What came of one input.
struct ConvertOutcome : ConvertResult {
  std::string input;
  bool one_of_many = false;  ///< Then its report names it.
  ExitCode code = ExitCode::kGood;
};

/// One conversion, of one input or several that are one rig (request.inputs.files), called `input`. `typed`: what was asked
/// for, as it was typed.
[[nodiscard]] ConvertOutcome convert_input(const std::string& input, const ConvertArguments& arguments,
                                           const TypedOptions& typed, Files& files);

}  // namespace fca::cli
