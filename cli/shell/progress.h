// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "streams.h"

#include <chrono>
#include <cstddef>
#include <mutex>

namespace fca::cli {

/// "312 of 10000" in the last line of a terminal, on standard error; nothing in a pipe or a file. May be used from several
/// threads.
class Progress {
 public:
  Progress(std::size_t total, Output& err);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step();

 private:
  Output& err_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point shown_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool on_terminal_;
};

}  // namespace fca::cli
