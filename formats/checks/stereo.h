// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "subject.h"

#include <functional>

namespace fca::checks {

/// Asked for only where there is a finding: to find a place takes as long as to write the file.
using FindPlace = std::function<SourceRange()>;

/// Turns, baseline and rectification of two cameras that the file takes for a stereo pair. `where`: their pose in the file.
void check_stereo_pair(const Subject& subject, const FindPlace& where, Findings& findings);

}  // namespace fca::checks
