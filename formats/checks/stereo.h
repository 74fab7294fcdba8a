// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "subject.h"

namespace fca::checks {

/// Turns, baseline and rectification of two cameras that the file takes for a stereo pair. `where`: their pose in the file.
void check_stereo_pair(const Subject& subject, const SourceRange& where, Findings& findings);

}  // namespace fca::checks
