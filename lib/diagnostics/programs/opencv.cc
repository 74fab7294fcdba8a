// SPDX-License-Identifier: BSD-3-Clause
// What OpenCV's functions make of a file.
#include "../rows.h"
#include "../topics.h"

namespace fca::diagnostics {

std::span<const CodeInfo> opencv_program_codes() { return {}; }

}  // namespace fca::diagnostics
