// SPDX-License-Identifier: BSD-3-Clause
#include "at_once.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace fca {

void at_once(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& body) {
  const std::size_t most = jobs > 0 ? jobs : std::max(1U, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) body(i);
  };
  std::vector<std::future<void>> others;
  for (std::size_t worker = 1; worker < std::min(count, most); ++worker) others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();
}

}  // namespace fca
