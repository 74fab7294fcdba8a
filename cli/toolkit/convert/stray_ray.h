// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/message.h>
#include <fca/toolkit/convert.h>

#include <optional>

namespace fca {

/// A message about the worst of a few rays of a table that do not belong to it: a fit without them is far better for all
/// others. nullopt if there are none, or the source is not a table.
[[nodiscard]] std::optional<Message> stray_ray(const ConvertedCamera& camera);

}  // namespace fca
