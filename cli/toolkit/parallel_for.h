// SPDX-License-Identifier: BSD-3-Clause
// Parallel work. If the system cannot start another thread (a limit on processes, no memory for a stack), the existing threads
// do all of it; that is not an error.
#pragma once

#include <cstddef>
#include <functional>
#include <thread>

namespace fca {

/// Calls body(0) .. body(count - 1), up to `jobs` at the same time (0: the number of processors), started in that order. The
/// calls must be independent. If one throws, no further call starts; when those that run have ended, this function throws the
/// first exception.
void parallel_for(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& body);

/// Runs `task` in a new thread. Use it for preparations that their user repeats if they did not happen (loading a library): if
/// no thread can be started, or the task throws, nothing happens. The returned thread's destructor waits for the task.
[[nodiscard]] std::jthread in_background(const std::function<void()>& task);

}  // namespace fca
