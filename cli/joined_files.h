// SPDX-License-Identifier: BSD-3-Clause
// Files of one camera each that are one rig (--join), written in their own format: each is edited by itself.
#pragma once

#include <fca/formats/calibration.h>

#include <optional>

namespace fca::cli {

/// One file per camera of `rig`, each an edit of the input that states the camera. `source`: as read; its cameras are the
/// rig's, in the same order. Nothing, without an error, where that is not how the rig came about: another format, or a camera
/// whose images were changed, whose input is not known any more; with errors where an input cannot be written.
[[nodiscard]] std::optional<Written> write_each_into_its_own(const Calibration& source, const Rig& rig, const Format& format,
                                                             const WriteOptions& options, Diagnostics& diagnostics);

}  // namespace fca::cli
