// SPDX-License-Identifier: BSD-3-Clause
// What is to be written: the options of `convert` that `report` has, too, because its page shows what they do.
#pragma once

#include "options.h"

#include <fca/toolkit/convert.h>

#include <optional>
#include <span>
#include <string>

namespace fca::cli {

/// --to; the help begins with `help`.
void add_to_option(Options& options, const std::string& help, ConvertRequest& request);

/// What a command says of --model.
struct ModelOption {
  std::string values = "MODEL";
  std::string help;       ///< Before the list of models;
  std::string more = {};  ///< after it.
};
/// --model
void add_model_option(Options& options, const ModelOption& option, TakeWord take);

/// All the others.
void add_target_options(Options& options, ConvertRequest& request);
/// --accept: reasons against the written file that do not stop it.
void add_accept_option(Options& options, std::vector<Acceptance>& accepted);

/// A usage error among them together, in words.
[[nodiscard]] std::optional<std::string> problem_with(const ConvertRequest& request);

/// Why one of them is without use where nothing is written; nothing where none was given.
[[nodiscard]] std::optional<std::string> target_without_file(const ConvertRequest& request);

/// Is the input, or what is written, of the format that has use for --opencv-model? Yes where nobody knows.
[[nodiscard]] bool has_use_for_opencv_model(const ConvertResult& result);
/// --opencv-model was given, and there is no use for it: a usage error, in words. `file`: an input, of that format.
[[nodiscard]] std::string opencv_model_without_use(const std::string& file, const Format& format);

}  // namespace fca::cli
