// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace fca::cli {

/// Part of the command's contract. Of several inputs, the largest is returned.
enum class ExitCode {
  kGood = 0,
  kJudgedBad = 1,  ///< Error limit exceeded, proof failed, --strict with a loss: nothing is written.
  kBadInput = 2,
  kUsage = 3,
  kIo = 4,
  kBug = 70,
};

[[nodiscard]] constexpr ExitCode worse(ExitCode a, ExitCode b) { return static_cast<int>(a) > static_cast<int>(b) ? a : b; }

}  // namespace fca::cli
