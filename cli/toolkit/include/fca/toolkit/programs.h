// SPDX-License-Identifier: BSD-3-Clause
// Reports what a program reads from a file: whether it loads the file, which cameras it reads, and how far these are from the
// file's meaning.
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
/// Finds a program by its id, by its format, or by a name that people use (fca/formats/program_names.h), in upper or lower
/// case. Null if there is none.
[[nodiscard]] const consumers::Consumer* find_program(std::string_view typed);
/// A program's reader of files with cameras, or of files without cameras. Kalibr and OpenVINS have one reader for each.
[[nodiscard]] const consumers::Consumer& reader_of(const consumers::Consumer& program, bool with_cameras);

/// The result of ask_program().
struct ProgramReading {
  /// Modes of the program that read the same from the file.
  struct Mode {
    std::vector<std::string> names;  ///< Names of the modes. Empty: the program has no modes.
    ProofResult proof;               ///< What the program reads in these modes.
    Verdict verdict;                 ///< Whether to use the file in these modes.
  };
  const consumers::Consumer* program = nullptr;
  bool reads_format = true;  ///< False if the program does not read the file's format.
  std::vector<Mode> modes;   ///< Empty if the program does not read the format.
};

/// Determines what a program reads, in each of its modes, from the calibration's file with cameras (from the first file, if
/// none has cameras). `inputs`: the options with which the calibration was read. `findings`: the findings of a check of the
/// file, for the verdict.
[[nodiscard]] ProgramReading ask_program(const consumers::Consumer& program, const Calibration& calibration,
                                         const Inputs& inputs, std::span<const Finding> findings = {});

}  // namespace fca
