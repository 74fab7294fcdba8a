// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "console.h"

#include <csignal>

namespace fca::cli {

/// While it lives and `hold` was asked for, Ctrl-C (SIGINT) waits, also in threads begun meanwhile; when it ends, what waited
/// ends the command as usual, with what was printed. Where the command was started with SIGINT ignored, it stays so.
class HeldInterrupt {
 public:
  HeldInterrupt(bool hold, const Console& console);
  ~HeldInterrupt();
  HeldInterrupt(const HeldInterrupt&) = delete;
  HeldInterrupt& operator=(const HeldInterrupt&) = delete;

  /// Did it come?
  [[nodiscard]] bool asked() const;

 private:
  const Console& console_;
  sigset_t before_{};
  bool held_ = false;
};

}  // namespace fca::cli
