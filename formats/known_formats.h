// SPDX-License-Identifier: BSD-3-Clause
// Files of programs whose formats fca-io does not read: people are told what they have, and what its poses and numbers mean.
#pragma once

#include <fca/message.h>

#include <cstdint>
#include <string_view>

namespace fca {

/// Has the text a syntax of those that fca-io parses? What has none may be a calibration with a mistake in it.
enum class Parsed : std::uint8_t { kYes, kNo };

/// "looks like OKVIS' configuration (T_SC and image_dimension)", and how to carry it over; nothing if the text looks like none
/// that is known.
[[nodiscard]] Message looks_like(std::string_view text, Parsed parsed);

}  // namespace fca
