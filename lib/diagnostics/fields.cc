// SPDX-License-Identifier: BSD-3-Clause
// Values under the keys of a file, in every format.
#include "rows.h"
#include "topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> field_codes() { return {}; }

}  // namespace fca::diagnostics
