// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/message.h>
#include <fca/toolkit/convert.h>

#include <optional>

namespace fca {

/// The worst of the few rays of a table that do not belong to it: a fit without them is far better for all others. Nothing
/// where the table has none, or the camera is no table.
[[nodiscard]] std::optional<Message> stray_ray(const ConvertedCamera& camera);

}  // namespace fca
