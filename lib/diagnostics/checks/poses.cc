// SPDX-License-Identifier: BSD-3-Clause
// What a check finds about poses.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> pose_check_codes() { return {}; }

}  // namespace fca::diagnostics
