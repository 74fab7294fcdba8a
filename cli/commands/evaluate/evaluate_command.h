// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/console.h"
#include "toolkit/evaluation.h"

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace fca::cli {

struct EvaluateArguments {
  std::string image;  ///< A path; empty: tables without images.
  bool json = false;
};

/// `evaluate`: the tables of the paper, recomputed.
void add_evaluate_command(CLI::App& app, EvaluateArguments& arguments, std::function<ExitCode(Console&)>& run);

/// The tables for people (evaluate_text.cc) and for scripts (evaluate_json.cc).
[[nodiscard]] std::string evaluate_text(const Evaluation& evaluation);
[[nodiscard]] std::string evaluate_json(const Evaluation& evaluation);

/// What went wrong in the paper's Table 3, in words.
[[nodiscard]] std::string sign_error_in_words(const EvaluatedPolynomials& polynomials);

}  // namespace fca::cli
