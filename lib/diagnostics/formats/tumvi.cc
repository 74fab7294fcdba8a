// SPDX-License-Identifier: BSD-3-Clause
// TUM-VI's chains and camera.txt, as read and written.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> tumvi_codes() { return {}; }

}  // namespace fca::diagnostics
