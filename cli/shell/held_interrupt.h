// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace fca::cli {

/// While it lives and `hold` was asked for, Ctrl-C (SIGINT) waits, also in threads begun meanwhile; when it ends, what waited
/// ends the command as usual. Where the command was started with SIGINT ignored, it stays so.
class HeldInterrupt {
 public:
  explicit HeldInterrupt(bool hold);
  ~HeldInterrupt();
  HeldInterrupt(const HeldInterrupt&) = delete;
  HeldInterrupt& operator=(const HeldInterrupt&) = delete;

  /// Did it come?
  [[nodiscard]] bool asked() const;

 private:
  sigset_t before_{};
  bool held_ = false;
};

}  // namespace fca::cli
