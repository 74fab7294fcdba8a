// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace fca::consumers {

/// Thrown in the command alone, which asks some programs in a module: the module is not there. what() is a sentence for people.
struct MissingModule : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fca::consumers
