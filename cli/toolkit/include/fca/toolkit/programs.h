// SPDX-License-Identifier: BSD-3-Clause
// What one program reads from a file: would it load it, which cameras does it see, and how far are they from what the file
// means?
#pragma once

#include <fca/formats/calibration.h>
#include <fca/formats/check.h>
#include <fca/formats/proof.h>
#include <fca/formats/verdict_value.h>
#include <fca/toolkit/inputs.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

/// The ids of all programs, as find_program() takes them.
[[nodiscard]] std::vector<std::string> program_ids();
/// The program of that id or of a name that people know it by (fca/formats/program_names.h), in any case; null if there is
/// none.
[[nodiscard]] const consumers::Consumer* find_program(std::string_view typed);
/// The same program's reader of files with cameras, or of those without: Kalibr and OpenVINS have two.
[[nodiscard]] const consumers::Consumer& reader_of(const consumers::Consumer& program, bool with_cameras);

struct ProgramReading {
  /// The program's modes that come to the same, and what they come to.
  struct Mode {
    std::vector<std::string> names;  ///< Empty: the program has none.
    ProofResult proof;
    Verdict verdict;  ///< Whether to use the file so.
  };
  const consumers::Consumer* program = nullptr;
  bool reads_format = true;
  std::vector<Mode> modes;  ///< Empty where it does not read the format.
};

/// Asks a program, in each of its modes, about the file of the calibration that specifies the cameras (else the first).
/// `inputs`: what counts as lens, and which of OpenCV's models its files' numbers are of. `findings`: about the file's meaning.
[[nodiscard]] ProgramReading ask_program(const consumers::Consumer& program, const Calibration& calibration,
                                         const Inputs& inputs, std::span<const Finding> findings = {});

}  // namespace fca
