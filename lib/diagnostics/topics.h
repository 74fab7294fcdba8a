// SPDX-License-Identifier: BSD-3-Clause
// Private: the parts of the table of codes, one topic each. A new one is a file, a function here, and a line in codes.cc.
#pragma once

#include <fca/code.h>

#include <span>

namespace fca::diagnostics {

[[nodiscard]] std::span<const CodeInfo> rig_codes();
[[nodiscard]] std::span<const CodeInfo> loss_codes();
[[nodiscard]] std::span<const CodeInfo> dso_codes();
[[nodiscard]] std::span<const CodeInfo> imu_codes();

}  // namespace fca::diagnostics
