// SPDX-License-Identifier: BSD-3-Clause
// Checks which camera of a pair is the left one.
#pragma once

#include <fca/rig/rig.h>
#include <fca/toolkit/convert.h>

namespace fca {

/// Adds a warning if the second camera is to the left of the first one although the first must be the left one.
/// `first_is_left`: the reason for that; empty: it need not be. If exchanging the cameras solves it, sets the result's
/// better_order.
void warn_of_wrong_side(const Rig& rig, const ConvertRequest& request, const Message& first_is_left, ConvertResult& result);

}  // namespace fca
