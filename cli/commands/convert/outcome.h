// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/options.h"
#include "shell/exit_code.h"
#include "shell/output_name.h"

#include <fca/toolkit/convert.h>

#include <string>
#include <vector>

namespace fca::cli {

/// What `convert` was asked for.
struct ConvertArguments {
  ConvertRequest request;           ///< Its inputs' files are one conversion's.
  std::vector<std::string> inputs;  ///< As typed: files, folders, patterns.
  OutputPlace output;
  bool in_place = false;
  bool one_input = true;  ///< No other one is converted into the same folder.
  bool print = false;     ///< Arguments of the program's command line, in place of the files.
  bool force = false;
  bool fsync = false;
  bool dry_run = false;
  bool json = false;
  int verbosity = 0;   ///< 1: the full report; more: with the parameters of the cameras.
  bool quiet = false;  ///< Errors only.
};

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
