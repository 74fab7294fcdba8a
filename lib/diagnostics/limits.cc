// SPDX-License-Identifier: BSD-3-Clause
// Numbers that no camera, rig or image can have.
#include "rows.h"
#include "topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> limit_codes() { return {}; }

}  // namespace fca::diagnostics
