// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base.h"
#include "loaded_views.h"

namespace fca {

/// Writes the rig in memory: into the base, or a fresh file where its program would refuse what the base's own layout makes of
/// it. `replaced`: names of the base's cameras whose place another camera takes.
[[nodiscard]] std::optional<Written> write_rig(const Calibration& source, const Rig& rig, const Base& base,
                                               const ConvertRequest& request, std::vector<std::string> replaced,
                                               LoadedViews& views, ConvertResult& result);

}  // namespace fca
