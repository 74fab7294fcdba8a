// SPDX-License-Identifier: BSD-3-Clause
// OpenVINS' chains, as read and written.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> openvins_codes() { return {}; }

}  // namespace fca::diagnostics
