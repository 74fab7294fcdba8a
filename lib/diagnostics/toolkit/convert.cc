// SPDX-License-Identifier: BSD-3-Clause
// What is said of a conversion as it was asked for.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> convert_codes() { return {}; }

}  // namespace fca::diagnostics
