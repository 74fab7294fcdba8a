// SPDX-License-Identifier: BSD-3-Clause
// What a conversion is for, by the name that people type.
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/format.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>
#include <string_view>

namespace fca {

struct Target {
  const Format* format = nullptr;
  const consumers::Consumer* program = nullptr;  ///< Who is to read the files; null: the format's own.
  std::optional<FormatLayout> layout = {};       ///< Of that program; nothing: the usual one.
  std::string extension = {};                    ///< With its point, where it chooses the syntax; empty: the usual one.
};

/// A format's id, or a program that one serves ("vins-fusion"), in any case. Nothing of any other name.
[[nodiscard]] std::optional<Target> find_target(std::string_view name);

}  // namespace fca
