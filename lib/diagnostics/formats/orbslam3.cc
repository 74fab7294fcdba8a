// SPDX-License-Identifier: BSD-3-Clause
// ORB-SLAM3's settings, as read and written.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> orbslam3_codes() { return {}; }

}  // namespace fca::diagnostics
