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

/// What is here in place of the paper's Table 4, in words.
[[nodiscard]] std::string replacement_in_words(const EvaluateResult& evaluation);

/// Figure 2 and, with pictures, Figure 3 as one HTML file (evaluate_page.cc).
[[nodiscard]] std::string evaluate_page(const EvaluateResult& evaluation);

}  // namespace fca::cli
