// SPDX-License-Identifier: BSD-3-Clause
// OpenCV's files, as read and written.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> opencv_codes() { return {}; }

}  // namespace fca::diagnostics
