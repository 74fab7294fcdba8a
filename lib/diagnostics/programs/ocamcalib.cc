// SPDX-License-Identifier: BSD-3-Clause
// What OCamCalib's reader says to a file.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> ocamcalib_program_codes() { return {}; }

}  // namespace fca::diagnostics
