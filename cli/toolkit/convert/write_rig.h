// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base.h"
#include "loaded_views.h"

namespace fca {

/// Makes the files that contain `rig`, in memory. There are three ways: an edit of the base, one file per joined input file, or
/// a fresh file. A fresh file is also written if the program would refuse the edited base and its text need not be kept.
/// `source`: the input. `replaced`: names of the base's cameras that another camera replaces. Returns nullopt after an error.
[[nodiscard]] std::optional<Written> write_rig(const Calibration& source, const Rig& rig, const Base& base,
                                               const ConvertRequest& request, std::vector<std::string> replaced,
                                               LoadedViews& views, ConvertResult& result);

}  // namespace fca
