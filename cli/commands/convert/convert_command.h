// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "toolkit/conversion.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fca::cli {

/// Adds `convert` to the application; `run` is set when it was chosen.
void add_convert_command(CLI::App& app, ConvertArguments& arguments, std::function<ExitCode(Console&)>& run);

/// "kb4 -> eucm, fitted"
[[nodiscard]] std::string camera_line(const CameraOutcome& camera);
/// "proof: Kalibr loads it; ...": what the real programs make of the written files, and below each line what belongs to it.
[[nodiscard]] std::string proofs_text(const ConvertOutcome& outcome);
/// The report for people (convert_text.cc) and for scripts (convert_json.cc).
[[nodiscard]] std::string convert_text(const ConvertOutcome& outcome, bool written);
[[nodiscard]] std::string convert_json(const std::vector<ConvertOutcome>& outcomes, const Console& console);

}  // namespace fca::cli
