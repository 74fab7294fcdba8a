// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

namespace fca {

/// Do the uncertainties of a rig, once all of its files are read, belong to its cameras: names, models, and the values where
/// both files specify them? An error at the place of each that does not; where values differ by less than a standard deviation,
/// a warning. Without effect in a rig without cameras.
[[nodiscard]] bool match_uncertainties(const Rig& rig, Diagnostics& diagnostics);

/// Is that all that the rig specifies, so that no program reads its file?
[[nodiscard]] bool is_uncertainty_alone(const Rig& rig);

}  // namespace fca
