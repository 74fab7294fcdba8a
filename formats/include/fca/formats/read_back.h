// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/format.h>

#include <optional>

namespace fca {

/// What a file that was written in memory says, as its own format reads it; nothing where that does not read it.
[[nodiscard]] std::optional<Rig> read_back(const Format& format, const Written::File& file, const ReadOptions& options = {});

/// The same of one of the files that say `rig`: what such a file leaves open, the rig and its writer know.
[[nodiscard]] std::optional<Rig> read_back(const Format& format, const Written::File& file, const Rig& rig,
                                           const Written& written);

}  // namespace fca
