// SPDX-License-Identifier: BSD-3-Clause
// What cannot be parsed.
#include "rows.h"
#include "topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> syntax_codes() { return {}; }

}  // namespace fca::diagnostics
