// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "descriptor.h"

#include <string>

namespace fca {

/// The prefix of temporary files' names.
inline constexpr const char* kTemporaryFile = ".fca-io-";

/// Opens a file without a name in that folder for reading and writing; it is gone when it is closed. If that fails, the
/// descriptor is -1 and errno has the reason.
[[nodiscard]] Descriptor unnamed_file_in(const std::string& folder);

}  // namespace fca
