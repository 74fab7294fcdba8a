// SPDX-License-Identifier: BSD-3-Clause
// Files of one camera each that are joined to one rig, or a part of one, written in their own format: each is edited by itself.
#pragma once

#include <fca/formats/calibration.h>

#include <optional>

namespace fca {

/// One file per camera of `rig`: an edit of the input of that format that states the camera, a fresh one for those of other
/// formats. `source`: as read; its cameras are the rig's, in the same order. Nothing, without an error, where no input can be
/// edited so: a format whose files hold several cameras (but for DSO's camera.txt where a .txt is asked for), or a camera whose
/// images were changed, whose input is not known any more; with errors where a file cannot be written.
[[nodiscard]] std::optional<Written> write_each_into_its_own(const Calibration& source, const Rig& rig, const Format& format,
                                                             const WriteOptions& options, Diagnostics& diagnostics);

}  // namespace fca
