// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "descriptor.h"

#include <string>

namespace fca {

/// What the name of a temporary file begins with, as long as it has one.
inline constexpr const char* kTemporaryFile = ".fca-io-";

/// A file in that folder without a name, to be read and written: it is gone when it is closed. Else -1, and errno says why.
[[nodiscard]] Descriptor unnamed_file_in(const std::string& folder);

}  // namespace fca
