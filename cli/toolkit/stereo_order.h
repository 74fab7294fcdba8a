// SPDX-License-Identifier: BSD-3-Clause
// Which of two cameras is the left one.
#pragma once

#include "conversion.h"

namespace fca::cli {

/// ORB-SLAM3 takes the first camera of a stereo file for the left one. Where the second one sits on its left, a warning with
/// the command that swaps them, if that puts it on the right.
void warn_of_wrong_side(const Rig& rig, const ConvertArguments& arguments, const ConvertOutcome& outcome,
                        Diagnostics& diagnostics);

}  // namespace fca::cli
