// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"
#include "outcome.h"

#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

/// Adds `convert` to the application.
void add_convert_command(Application& application);

/// "kb4 -> eucm", "kb4"
[[nodiscard]] std::string models_in_words(const ConvertedCamera& camera);
/// "kept", "exact" or "fitted"
[[nodiscard]] std::string_view way_in_words(const ConvertedCamera& camera);
/// Both: "kb4 -> eucm, fitted"
[[nodiscard]] std::string camera_line(const ConvertedCamera& camera);
/// How a real program reads the written files.
struct ProofWords {
  std::string verdict;               ///< "Kalibr loads it; ..."
  std::vector<std::string> details;  ///< What belongs to it, a line each.
};
[[nodiscard]] std::vector<ProofWords> proofs_in_words(const ConvertResult& result);
/// How the program that the files are for sees the camera; null where that is not known.
[[nodiscard]] const CameraDistance* distance_of(const ConvertResult& result, const ConvertedCamera& camera);
/// The verdict and what a user must act on, in some ten lines (summary.cc). `is_short`: all that is printed; else the full
/// report follows.
[[nodiscard]] std::string convert_summary(const ConvertOutcome& outcome, bool written, bool is_short);
/// The same without its first line.
[[nodiscard]] std::string summary_lines(const ConvertResult& outcome, bool is_short);
/// The full report (convert_text.cc), with the cameras' parameters where those are wanted.
[[nodiscard]] std::string convert_text(const ConvertOutcome& outcome, bool written, bool with_parameters);

}  // namespace fca::cli
