// SPDX-License-Identifier: BSD-3-Clause
// What WoodScape's readers say to a file.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> woodscape_program_codes() { return {}; }

}  // namespace fca::diagnostics
