// SPDX-License-Identifier: BSD-3-Clause
// The start of a conversion: its input, and the base that it edits.
#pragma once

#include "base.h"
#include "known_conversions.h"
#include "loaded_views.h"

#include <fca/formats/check.h>
#include <fca/rig/contradictions.h>

#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <vector>

namespace fca {

struct Start {
  std::optional<Calibration> into;  ///< The file of --into; nullopt without one.
  Calibration input;
  Base base;                      ///< Points into `into` or `input`.
  std::vector<Finding> findings;  ///< Findings about the meaning of the input.
  /// The input's rig with its cameras in the order of the file, and with the contradicting pose that `input` lacks.
  Rig rig_of_input;
  std::optional<Contradiction> outvoted;
  std::unique_ptr<KnownConversions> known = std::make_unique<KnownConversions>();
  std::unique_ptr<LoadedViews> views = std::make_unique<LoadedViews>();
};

/// Adds diagnostics as findings: warnings and errors, except those about poor fits, which the proofs cover.
void add_findings(std::span<const Diagnostic> entries, std::vector<Finding>& findings);

/// Reads the input and the base; false with errors. `programs`: receives the thread that prepares the target's programs
/// meanwhile.
[[nodiscard]] bool read_start(const ConvertRequest& request, Files& files, Start& start, std::jthread& programs,
                              ConvertResult& result);

}  // namespace fca
