// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base.h"
#include "loaded_views.h"

namespace fca {

/// Writes the rig in memory: into the base, or as a fresh file if the program would refuse the edited base. `replaced`: names
/// of the base's cameras that another camera replaces.
[[nodiscard]] std::optional<Written> write_rig(const Calibration& source, const Rig& rig, const Base& base,
                                               const ConvertRequest& request, std::vector<std::string> replaced,
                                               LoadedViews& views, ConvertResult& result);

}  // namespace fca
