// SPDX-License-Identifier: BSD-3-Clause
#include "held_interrupt.h"

namespace fca::cli {

HeldInterrupt::HeldInterrupt(bool hold, const Console& console) : console_(console) {
  if (!hold) return;
  struct sigaction action {};
  if (sigaction(SIGINT, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) return;
  sigset_t interrupt;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  held_ = pthread_sigmask(SIG_BLOCK, &interrupt, &before_) == 0;
}

HeldInterrupt::~HeldInterrupt() {
  if (!held_) return;
  console_.flush();  // it may be the end
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool HeldInterrupt::asked() const {
  sigset_t pending;
  return held_ && sigpending(&pending) == 0 && sigismember(&pending, SIGINT) == 1;
}

}  // namespace fca::cli
