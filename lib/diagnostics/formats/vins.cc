// SPDX-License-Identifier: BSD-3-Clause
// VINS-Fusion's files, as read and written.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> vins_codes() { return {}; }

}  // namespace fca::diagnostics
