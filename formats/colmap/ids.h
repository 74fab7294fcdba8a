// SPDX-License-Identifier: BSD-3-Clause
// The numbers that COLMAP's cameras, rigs and other sensors go by: camera_t, rig_t and the like (colmap@5d968cf, util/types.h)
// are 32 bits without a sign, and the largest number stands for none.
#pragma once

#include "../fields.h"

#include <fca/rig/rig.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace fca::colmap {

using Id = std::uint32_t;
inline constexpr Id kLargestId = UINT32_MAX - 1;

/// Of a camera's number among the extra fields.
inline constexpr std::string_view kId = "CAMERA_ID";

/// The number that a word says; nothing if it is none of them.
[[nodiscard]] std::optional<Id> parse_id(std::string_view word);
/// The same, with an error at the word. `what`: "CAMERA_ID".
[[nodiscard]] std::optional<Id> read_id(const text::Node& word, std::string_view what, fields::Reader& reader);

/// The numbers that cameras go by: those that they had in a file of cameras, else 1, 2, ...
[[nodiscard]] std::vector<Id> camera_ids(const Rig& rig);

}  // namespace fca::colmap
