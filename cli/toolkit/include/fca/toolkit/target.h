// SPDX-License-Identifier: BSD-3-Clause
// Finds the target of a conversion by the name that people type.
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
  const consumers::Consumer* program = nullptr;  ///< The program that will read the files. Null: the format's own program.
  std::optional<FormatLayout> layout = {};       ///< The layout that this program reads. nullopt: the usual one.
  std::string extension = {};                    ///< With its dot, if it chooses the syntax. Empty: the usual one.
};

/// Finds a target by the id of a format or by the name of a program that reads a format ("vins-fusion"), in upper or lower
/// case. nullopt for any other name.
[[nodiscard]] std::optional<Target> find_target(std::string_view name);

}  // namespace fca
