// SPDX-License-Identifier: BSD-3-Clause
// Which of two cameras is the left one.
#pragma once

#include <fca/rig/rig.h>
#include <fca/toolkit/convert.h>

namespace fca {

/// A warning where the second camera sits on the left of the first one, and the first is to be the left one (`first_is_left`
/// says why; empty: it is not). If exchanging them puts that right, the result's better_order does it.
void warn_of_wrong_side(const Rig& rig, const ConvertRequest& request, const Message& first_is_left, ConvertResult& result);

}  // namespace fca
