// SPDX-License-Identifier: BSD-3-Clause
// What is said of the other requests, and of files that are saved.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> request_codes() { return {}; }

}  // namespace fca::diagnostics
