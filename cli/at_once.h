// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace fca::cli {

/// Calls body(0) .. body(count - 1), as many at the same time as there are processors. They must have nothing to do with each
/// other.
void at_once(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace fca::cli
