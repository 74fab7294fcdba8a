// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <system_error>
#include <vector>

#include <sys/resource.h>

namespace fca {

namespace {

/// True if the address space is limited to less than 512 MB. Then no threads are started: the stack of a thread takes 8 MB,
/// which glibc does not free when the thread ends, and OpenCV's module needs this memory.
bool address_space_is_short() {
  constexpr rlim_t kNeededBytes = 512UL << 20U;
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur < kNeededBytes;
}

/// Starts the function in a new thread. If no thread can be started, the returned thread is not joinable.
template <typename Function>
std::jthread started(const Function& function) {
  if (address_space_is_short()) return {};
  try {
    return std::jthread(function);
  } catch (const std::system_error&) {  // a limit on threads, or no memory for a stack
    return {};
  } catch (const std::bad_alloc&) {
    return {};
  }
}

}  // namespace

void parallel_for(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& body) {
  const std::size_t threads = std::min(count, jobs > 0 ? jobs : std::max(1U, std::thread::hardware_concurrency()));
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::exception_ptr failure;  // written by the thread that sets `failed`
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count && !failed; i = next++) body(i);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;  // their destructors join them
    while (others.size() + 1 < threads) {
      std::jthread other = started(work);
      if (!other.joinable()) break;
      others.push_back(std::move(other));
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

std::jthread in_background(const std::function<void()>& task) {
  return started([task] {
    try {
      task();
    } catch (...) {  // NOLINT(bugprone-empty-catch): the code that needs the preparation repeats it and reports the error
    }
  });
}

}  // namespace fca
