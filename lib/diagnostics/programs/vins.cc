// SPDX-License-Identifier: BSD-3-Clause
// What VINS-Fusion says to a file.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> vins_program_codes() { return {}; }

}  // namespace fca::diagnostics
