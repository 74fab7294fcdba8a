// SPDX-License-Identifier: BSD-3-Clause
// Programs that read some of COLMAP's models beside their own file, a JSON object.
#pragma once

#include "colmap.h"

#include <fca/formats/consumers/consumer.h>

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace fca::consumers {

/// Does the file begin as a JSON object, maybe behind a BOM?
[[nodiscard]] bool is_json(std::string_view bytes);

/// What the program makes of a camera of COLMAP's, where it is not what COLMAP does. `params`: of its line.
using OwnReading = std::function<void(const colmap::Model& model, const std::vector<double>& params, ConsumerCamera& camera)>;

/// What the program reads of COLMAP's file of cameras: it refuses any that has another model than these (empty: none).
[[nodiscard]] ConsumerView load_taken_of_colmap(std::string_view bytes, const LoadOptions& options, std::string_view program,
                                                std::span<const std::string_view> models, const OwnReading& own = {});

}  // namespace fca::consumers
