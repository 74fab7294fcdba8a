// SPDX-License-Identifier: BSD-3-Clause
// What the ORB-SLAM programs say to a file.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> orbslam_program_codes() { return {}; }

}  // namespace fca::diagnostics
