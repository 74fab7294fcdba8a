// SPDX-License-Identifier: BSD-3-Clause
// What a check finds in a file's bytes, and of the programs that read it.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> file_check_codes() { return {}; }

}  // namespace fca::diagnostics
