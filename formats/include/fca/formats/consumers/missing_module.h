// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>

#include <stdexcept>
#include <utility>

namespace fca::consumers {

/// Thrown in the command alone, which asks some programs in a module: the module is not there. what() is the id of `facts`.
struct MissingModule : std::runtime_error {
  explicit MissingModule(Message message) : std::runtime_error(id_of(message)), facts(std::move(message)) {}

  Message facts;  ///< What the module is for, and why it cannot be loaded.
};

}  // namespace fca::consumers
