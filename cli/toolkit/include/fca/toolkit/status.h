// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>

#include <algorithm>
#include <cstdint>

namespace fca {

/// The outcome of a request. The values are in order: later ones are worse.
enum class Status : std::uint8_t {
  kDone,
  kRejected,    ///< Done, but the result is not good enough: it exceeds a limit, a program refuses it, or something is lost.
  kBadInput,    ///< A file is not a calibration, or lacks something that the request needs.
  kBadRequest,  ///< The request is impossible for any files, or names something that the files do not contain.
  kUnreadable,  ///< A file cannot be opened.
};

[[nodiscard]] constexpr Status worse(Status a, Status b) { return std::max(a, b); }

/// The status that follows from the errors: kDone if there are none, kUnreadable or kBadRequest for some codes, else kBadInput.
[[nodiscard]] Status status_of(const Diagnostics& diagnostics);

}  // namespace fca
