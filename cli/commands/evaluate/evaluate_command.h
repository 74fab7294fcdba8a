// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"

#include <fca/toolkit/evaluate.h>

#include <string>

namespace fca::cli {

/// `evaluate`: the tables of the paper, recomputed.
void add_evaluate_command(Application& application);

/// The tables for people (evaluate_text.cc) and for scripts (evaluate_json.cc).
[[nodiscard]] std::string evaluate_text(const EvaluateResult& evaluation);
[[nodiscard]] std::string evaluate_json(const EvaluateResult& evaluation);

/// What went wrong in the paper's Table 3, in words.
[[nodiscard]] std::string sign_error_in_words(const EvaluatedPolynomials& polynomials);

}  // namespace fca::cli
