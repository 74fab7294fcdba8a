// SPDX-License-Identifier: BSD-3-Clause
// One defect, one finding: the format's reader, the program and a topic may all have noticed it.
#pragma once

#include <fca/formats/check.h>

namespace fca::checks {

/// Of two findings about the same defect the one with the better words stays, as severe as the worse of the two, at the place
/// and with the fix that one of them has.
void deduplicate(CheckReport& report);

}  // namespace fca::checks
