// SPDX-License-Identifier: BSD-3-Clause
// Programs that read some of COLMAP's models next to their own file, a JSON object.
#pragma once

#include "colmap.h"

#include <fca/formats/consumers/consumer.h>

#include <span>
#include <string_view>

namespace fca::consumers {

/// Does the file begin as a JSON object, maybe after a BOM?
[[nodiscard]] bool is_json(std::string_view bytes);

/// What the program reads of COLMAP's file of cameras. It refuses a model that is none of these (empty: it takes all).
[[nodiscard]] ConsumerView load_taken_of_colmap(std::string_view bytes, std::string_view program,
                                                std::span<const std::string_view> models, const colmap::OwnReading& own = {});

}  // namespace fca::consumers
