// SPDX-License-Identifier: BSD-3-Clause
// What a check finds about lenses and images.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> lens_check_codes() { return {}; }

}  // namespace fca::diagnostics
