// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/status.h>

namespace fca::cli {

/// Part of the command's contract. Of several inputs, the largest is returned.
enum class ExitCode {
  kGood = 0,
  kRejected = 1,  ///< Error limit exceeded, proof failed, --strict with a loss: nothing is written.
  kBadInput = 2,
  kUsage = 3,
  kIo = 4,
  kNotReported = 5,  ///< The files are written, and what there was to say of them could not be printed.
  kBug = 70,
};

[[nodiscard]] constexpr ExitCode worse(ExitCode a, ExitCode b) { return static_cast<int>(a) > static_cast<int>(b) ? a : b; }

[[nodiscard]] constexpr ExitCode exit_code(Status status) {
  switch (status) {
    case Status::kDone:
      return ExitCode::kGood;
    case Status::kRejected:
      return ExitCode::kRejected;
    case Status::kBadInput:
      return ExitCode::kBadInput;
    case Status::kBadRequest:
      return ExitCode::kUsage;
    case Status::kUnreadable:
      return ExitCode::kIo;
  }
  return ExitCode::kBug;
}

}  // namespace fca::cli
