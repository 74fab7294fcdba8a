// SPDX-License-Identifier: BSD-3-Clause
#include "held_interrupt.h"

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

/// What ends a command from outside and can wait: Ctrl-C, kill, a closed terminal.
constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN;
}

}  // namespace

HeldInterrupt::HeldInterrupt(bool hold, const Console& console) : console_(console) {
  if (!hold) return;
  sigset_t interrupts;
  sigemptyset(&interrupts);
  for (const int signal : kSignals) {
    if (!is_ignored(signal)) sigaddset(&interrupts, signal);
  }
  held_ = pthread_sigmask(SIG_BLOCK, &interrupts, &before_) == 0;
}

HeldInterrupt::~HeldInterrupt() {
  if (!held_) return;
  console_.flush();  // it may be the end
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool HeldInterrupt::asked() const {
  sigset_t pending;
  if (!held_ || sigpending(&pending) != 0) return false;
  return std::ranges::any_of(kSignals, [&pending](int signal) { return sigismember(&pending, signal) == 1; });
}

}  // namespace fca::cli
