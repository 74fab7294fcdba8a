// SPDX-License-Identifier: BSD-3-Clause
// Kalibr's chains, as read and written.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> kalibr_codes() { return {}; }

}  // namespace fca::diagnostics
