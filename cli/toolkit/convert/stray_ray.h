// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/message.h>
#include <fca/toolkit/convert.h>

#include <optional>

namespace fca {

/// If the source camera is a table of rays and a few of its rays are wrong: a message about the worst one. Rays are wrong if a
/// fit without them is far better for all other rays. nullopt if no ray is wrong, or the source is not a table, or the target
/// is a table too.
[[nodiscard]] std::optional<Message> stray_ray(const ConvertedCamera& camera);

}  // namespace fca
