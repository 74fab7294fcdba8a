// SPDX-License-Identifier: BSD-3-Clause
#include "at_once.h"

#include <algorithm>
#include <future>
#include <thread>
#include <vector>

namespace fca::cli {

void at_once(std::size_t count, const std::function<void(std::size_t)>& body) {
  const std::size_t workers = std::min<std::size_t>(count, std::max(1U, std::thread::hardware_concurrency()));
  const auto every_nth = [&](std::size_t first) {
    for (std::size_t i = first; i < count; i += workers) body(i);
  };
  std::vector<std::future<void>> others;
  for (std::size_t first = 1; first < workers; ++first) others.push_back(std::async(std::launch::async, every_nth, first));
  every_nth(0);
  for (std::future<void>& other : others) other.get();
}

}  // namespace fca::cli
