// SPDX-License-Identifier: BSD-3-Clause
// Basalt's calibrations, as read and written.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> basalt_codes() { return {}; }

}  // namespace fca::diagnostics
