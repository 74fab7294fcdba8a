// SPDX-License-Identifier: BSD-3-Clause
// What a program does with a file, for people.
#pragma once

#include <fca/toolkit/programs.h>

#include <string>
#include <vector>

namespace fca::cli {

/// What a program that loads a file gets wrong in it, a sentence each: parts of the image first, then what it says itself.
/// `lens_given`: the shares are of the lens, as --max-angle or --lens-circle say it.
[[nodiscard]] std::vector<std::string> misreadings(const ProofResult& proof, bool lens_given);

/// All of it in words. `file`: the input's name, for a command.
[[nodiscard]] std::string program_reading_text(const ProgramReading& reading, const Calibration& calibration,
                                               const std::string& file, bool lens_given);

}  // namespace fca::cli
