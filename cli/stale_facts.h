// SPDX-License-Identifier: BSD-3-Clause
// Facts beside the calibration that a changed image makes wrong.
#pragma once

#include <fca/formats/format.h>

namespace fca::cli {

/// Warns of what an edited file still says about the images as they were calibrated: nobody but its owner can compute it anew.
void warn_of_stale_facts(const Rig& rig, const Written& written, Diagnostics& diagnostics);

}  // namespace fca::cli
