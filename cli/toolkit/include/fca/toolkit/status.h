// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>

#include <algorithm>
#include <cstdint>

namespace fca {

/// How a request ended. Of several, the worst is the last.
enum class Status : std::uint8_t {
  kDone,
  kRejected,    ///< Done, and the result is not good enough: a limit is exceeded, a program refuses it, something is lost.
  kBadInput,    ///< A file is no calibration, or not one that serves.
  kBadRequest,  ///< The request asks for what cannot be, whatever the files are, or names what they do not hold.
  kUnreadable,  ///< A file cannot be opened.
};

[[nodiscard]] constexpr Status worse(Status a, Status b) { return std::max(a, b); }

/// kDone without errors; kBadInput with them, unless their codes say something else.
[[nodiscard]] Status status_of(const Diagnostics& diagnostics);

}  // namespace fca
