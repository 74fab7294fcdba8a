// SPDX-License-Identifier: BSD-3-Clause
// Runs work in parallel threads. If the system cannot start another thread (because of a limit on processes, or without memory
// for a stack), the existing threads do all the work; this is not an error.
#pragma once

#include <cstddef>
#include <functional>
#include <thread>

namespace fca {

/// Calls body(0), body(1), ..., body(count - 1), and starts the calls in this order. `jobs`: the number of calls that run at
/// the same time (0: number of processors). The calls must be independent. If a call throws, no other call is started; the
/// function waits for the running calls and rethrows the first exception.
void parallel_for(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& body);

/// Runs `task` in a new thread. If no thread can be started, the task does not run, and exceptions of the task are ignored. So
/// use the function only for optional preparations (loading a library). The destructor of the returned thread waits for the
/// task.
[[nodiscard]] std::jthread in_background(const std::function<void()>& task);

}  // namespace fca
