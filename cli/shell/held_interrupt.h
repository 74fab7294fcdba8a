// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "console.h"

#include <csignal>

namespace fca::cli {

/// While it lives and `hold` was asked for, Ctrl-C (SIGINT), SIGTERM and SIGHUP wait, also in threads begun meanwhile; when it
/// ends, what waited ends the command as usual, with what was printed. A signal that the command was started to ignore stays
/// ignored.
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
