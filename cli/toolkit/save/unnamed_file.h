// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "descriptor.h"

#include <string>

namespace fca {

/// The prefix of the names of temporary files.
inline constexpr const char* kTemporaryFile = ".fca-io-";

/// Creates a file without a name in the folder and opens it for reading and writing. The file disappears when it is closed. If
/// it cannot be created, the descriptor is -1 and errno has the reason.
[[nodiscard]] Descriptor unnamed_file_in(const std::string& folder);

}  // namespace fca
