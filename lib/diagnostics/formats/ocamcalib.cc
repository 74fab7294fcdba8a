// SPDX-License-Identifier: BSD-3-Clause
// OCamCalib's files, as read and written.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> ocamcalib_codes() { return {}; }

}  // namespace fca::diagnostics
