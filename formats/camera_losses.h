// SPDX-License-Identifier: BSD-3-Clause
// The loss ledger of formats that hold one camera per file and little else (OCamCalib, WoodScape).
#pragma once

#include <fca/formats/format.h>

#include <span>
#include <string_view>
#include <vector>

namespace fca {

/// What of `rig` such a file has no place for: time offsets, topics, frame rates, IMUs, the baseline, and poses, all of them
/// or, with a `kept_frame` ("vehicle"), all but those of cameras in that frame. `program`: who reads the file, for people.
void list_camera_losses(const Rig& rig, std::string_view program, std::string_view kept_frame, std::vector<Loss>& losses);

}  // namespace fca
