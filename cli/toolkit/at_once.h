// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace fca {

/// Calls body(0) .. body(count - 1), up to `jobs` at the same time (0: as many as there are processors), begun in that order.
/// They must have nothing to do with each other.
void at_once(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& body);

}  // namespace fca
