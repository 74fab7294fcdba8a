// SPDX-License-Identifier: BSD-3-Clause
// How two calibrations differ, and by which mistake.
#include "rows.h"
#include "topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> comparison_codes() { return {}; }

}  // namespace fca::diagnostics
