// SPDX-License-Identifier: BSD-3-Clause
// What is said of inputs.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> reading_codes() { return {}; }

}  // namespace fca::diagnostics
