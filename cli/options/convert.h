// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
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
  bool force = false;
  bool fsync = false;
  bool dry_run = false;
  bool json = false;        ///< One document.
  bool json_lines = false;  ///< A line for each input, and `json`.
  int verbosity = 0;        ///< 1: the full report; more: with the parameters of the cameras.
  bool quiet = false;       ///< Errors only.
};

void add_convert_options(Options& options, ConvertArguments& arguments);

/// A usage error, in words, once the inputs were looked for. `many`: they are more than one conversion.
[[nodiscard]] std::optional<std::string> problem_with(const ConvertArguments& arguments, bool many);

}  // namespace fca::cli
