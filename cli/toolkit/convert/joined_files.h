// SPDX-License-Identifier: BSD-3-Clause
// Writes joined files of one camera each in their own format: each input file is edited by itself.
#pragma once

#include <fca/formats/calibration.h>

#include <optional>

namespace fca {

/// Writes one file per camera of `rig`: an edit of the input file of that format that contains the camera, or a fresh file for
/// a camera from another format. `source`: as read; its cameras are the rig's, in the same order. nullopt, without an error, if
/// no input can be edited in this way: the format's files hold several cameras (except DSO's camera.txt, if .txt is the
/// extension), or a camera's images were changed, so that its input file is not known. nullopt, with errors, if a file cannot
/// be written.
[[nodiscard]] std::optional<Written> write_each_into_its_own(const Calibration& source, const Rig& rig, const Format& format,
                                                             const WriteOptions& options, Diagnostics& diagnostics);

}  // namespace fca
