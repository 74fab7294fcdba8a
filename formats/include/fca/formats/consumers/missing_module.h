// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/text/message.h>
#include <fca/message.h>

#include <stdexcept>
#include <utility>

namespace fca::consumers {

/// Thrown in the command alone, which asks some programs in a module: the module is not there. what() is `facts` in words.
struct MissingModule : std::runtime_error {
  explicit MissingModule(Message message) : std::runtime_error(text::text_of(message)), facts(std::move(message)) {}

  Message facts;  ///< What the module is for, and why it cannot be loaded.
};

}  // namespace fca::consumers
