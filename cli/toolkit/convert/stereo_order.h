// SPDX-License-Identifier: BSD-3-Clause
// Checks that the first camera of a stereo pair is the left one, for programs that require it.
#pragma once

#include <fca/rig/rig.h>
#include <fca/toolkit/convert.h>

namespace fca {

/// Adds a warning if the second camera of `rig` is to the left of the first one although the program requires the opposite.
/// `first_is_left`: the reason why the first camera must be the left one; if it is empty, this function does nothing. If
/// exchanging the two cameras helps, sets result.better_order.
void warn_of_wrong_side(const Rig& rig, const ConvertRequest& request, const Message& first_is_left, ConvertResult& result);

}  // namespace fca
