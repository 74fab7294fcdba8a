// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

namespace fca::cli {

namespace {

constexpr std::size_t kBarWidth = 40;
constexpr auto kPause = std::chrono::milliseconds(100);  // between two looks of an eye
constexpr std::string_view kEraseLine = "\r\x1b[K";

bool can_redraw(const Output& output) {
  const char* term = std::getenv("TERM");
  return output.is_terminal() && term != nullptr && std::string_view(term) != "dumb";
}

}  // namespace

Progress::Progress(std::size_t total, Output& err)
    : err_(err), total_(std::max<std::size_t>(total, 1)), on_terminal_(can_redraw(err)) {}

Progress::~Progress() {
  if (on_terminal_) err_.write(kEraseLine);
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
  err_.write(std::string(kEraseLine) + "[" + bar + "] " + std::to_string(done_) + " of " + std::to_string(total_));
  static_cast<void>(err_.flush());
}

}  // namespace fca::cli
