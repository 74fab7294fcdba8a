// SPDX-License-Identifier: BSD-3-Clause
// Several inputs converted at the same time, and what came of them in a few lines.
#pragma once

#include "outcome.h"
#include "shell/calibration_files.h"
#include "shell/held_interrupt.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fca::cli {

struct Batch {
  std::vector<ConvertOutcome> outcomes;  ///< In the order of the inputs.
  std::size_t skipped = 0;               ///< Files met in folders, or by patterns, that hold no camera.
  std::size_t left = 0;                  ///< Not tried: Ctrl-C.
  std::size_t unwritten = 0;             ///< Converted and not written: Ctrl-C.
};

/// Few inputs have their reports; many have a line each in the table, and --json has everything.
[[nodiscard]] bool is_told_in_full(std::size_t inputs);

/// Converts every input (with --join: all as one), arguments.jobs at the same time, until the interrupt. `known`: what was
/// parsed of them already.
[[nodiscard]] Batch convert_batch(const std::vector<FoundFile>& inputs, const ConvertArguments& arguments,
                                  const TypedOptions& typed, const HeldInterrupt& interrupt, const Files& known,
                                  Console& console);

/// One line for each of several inputs, and one for all. `written`: what was converted was to be written (no --dry-run).
[[nodiscard]] std::string batch_text(const Batch& batch, bool written);

}  // namespace fca::cli
