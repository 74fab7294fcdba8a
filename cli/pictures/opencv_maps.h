// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pictures.h"

namespace fca::cli::module {

[[nodiscard]] std::optional<std::string> map_file(const ImageMap& map, MapNumbers numbers, bool compressed);

}  // namespace fca::cli::module
