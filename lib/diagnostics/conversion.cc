// SPDX-License-Identifier: BSD-3-Clause
// What happens when a model is fitted and judged.
#include "rows.h"
#include "topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> conversion_codes() { return {}; }

}  // namespace fca::diagnostics
