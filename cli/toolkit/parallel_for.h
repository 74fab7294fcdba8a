// SPDX-License-Identifier: BSD-3-Clause
// Work on several processors at a time. Where the system starts no further thread (a limit on processes, no memory for a
// stack), the threads that there are do all of it: that is no error.
#pragma once

#include <cstddef>
#include <functional>
#include <thread>

namespace fca {

/// Calls body(0) .. body(count - 1), up to `jobs` at the same time (0: as many as there are processors), begun in that order.
/// They must have nothing to do with each other. If one throws, no further one begins, and when those that run have ended, the
/// first exception is thrown here.
void parallel_for(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& body);

/// Runs `task` in a thread of its own. It is for preparations that their user repeats if they did not happen (loading a
/// library): where no thread can be started, or where the task throws, nothing happens. The returned thread's destructor waits
/// for the task.
[[nodiscard]] std::jthread in_background(const std::function<void()>& task);

}  // namespace fca
