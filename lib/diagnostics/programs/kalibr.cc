// SPDX-License-Identifier: BSD-3-Clause
// What Kalibr says to a file.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> kalibr_program_codes() { return {}; }

}  // namespace fca::diagnostics
