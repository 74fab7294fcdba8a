// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include <unistd.h>

namespace fca::cli {

namespace {

constexpr std::size_t kBarWidth = 40;
constexpr auto kPause = std::chrono::milliseconds(100);  // between two looks of an eye
constexpr std::string_view kEraseLine = "\r\x1b[K";

bool is_terminal() {
  const char* term = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && term != nullptr && std::string_view(term) != "dumb";
}

}  // namespace

Progress::Progress(std::size_t total) : total_(std::max<std::size_t>(total, 1)), on_terminal_(is_terminal()) {}

Progress::~Progress() {
  if (on_terminal_) std::fprintf(stderr, "%s", std::string(kEraseLine).c_str());
}

void Progress::step() {
  if (!on_terminal_) return;
  const std::scoped_lock lock(mutex_);
  ++done_;
  const auto now = std::chrono::steady_clock::now();
  if (now - shown_ < kPause && done_ < total_) return;
  shown_ = now;
  const std::size_t filled = kBarWidth * done_ / total_;
  const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
  std::fprintf(stderr, "%s[%s] %zu of %zu", std::string(kEraseLine).c_str(), bar.c_str(), done_, total_);
  std::fflush(stderr);
}

}  // namespace fca::cli
