// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

namespace fca::internal {

/// Calls f with the kernel that a variant holds. Not std::visit: its table of functions cannot be inlined.
template <class... Kernels, class F>
void with_kernel(const std::variant<Kernels...>& variant, const F& f) {
  const auto try_one = [&](const auto* kernel) {
    if (kernel != nullptr) f(*kernel);
  };
  (try_one(std::get_if<Kernels>(&variant)), ...);
}

}  // namespace fca::internal
