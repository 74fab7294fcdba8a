// SPDX-License-Identifier: BSD-3-Clause
// What a conversion begins with: its input, and the base that it is written into.
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
  std::optional<Calibration> into;  ///< The request's base.
  Calibration input;
  Base base;                      ///< Points into the two above.
  std::vector<Finding> findings;  ///< About the meaning of the input.
  Rig rig_of_input;  ///< Its cameras in the order of the file, and with the pose that was left out of `input`, if one was.
  std::optional<Contradiction> outvoted;
  std::unique_ptr<KnownConversions> known = std::make_unique<KnownConversions>();
  std::unique_ptr<LoadedViews> views = std::make_unique<LoadedViews>();
};

/// What was found since the input was read: warnings and errors. How good a fit is, the proofs say.
void add_findings(std::span<const Diagnostic> entries, std::vector<Finding>& findings);

/// False with errors. `programs`: who reads the target gets ready meanwhile.
[[nodiscard]] bool read_start(const ConvertRequest& request, Files& files, Start& start, std::jthread& programs,
                              ConvertResult& result);

}  // namespace fca
