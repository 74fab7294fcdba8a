// SPDX-License-Identifier: BSD-3-Clause
// The start of a conversion: reads the input, and the base whose text is edited.
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

/// What a conversion starts with. It stays the same while several ways to write the files are tried, except for the caches.
struct Start {
  std::optional<Calibration> into;  ///< The calibration in the file of --into; nullopt without --into.
  Calibration input;                ///< The input, reduced to the chosen cameras and for the changed images.
  Base base;                        ///< The file to edit. Points into `into` or `input`.
  std::vector<Finding> findings;    ///< Findings about the meaning of the input.
  /// The rig of `input` before its cameras were reordered and a contradicting pose was removed.
  Rig rig_of_input;
  std::optional<Contradiction> outvoted;  ///< Names the pose that was removed from `input`; nullopt if none was.
  /// Caches that the tries share.
  std::unique_ptr<KnownConversions> known = std::make_unique<KnownConversions>();
  std::unique_ptr<LoadedViews> views = std::make_unique<LoadedViews>();
};

/// Adds the warnings and errors among the diagnostics as findings, except warnings of poor fits: the proofs show such errors.
void add_findings(std::span<const Diagnostic> entries, std::vector<Finding>& findings);

/// Reads the input and the base. Fills `start` and the target and source formats of `result`. Returns false after errors.
/// `programs`: receives a thread that meanwhile prepares the readers of the target's programs.
[[nodiscard]] bool read_start(const ConvertRequest& request, Files& files, Start& start, std::jthread& programs,
                              ConvertResult& result);

}  // namespace fca
