// SPDX-License-Identifier: BSD-3-Clause
// Writes joined input files that have one camera each: edits each of them by itself.
#pragma once

#include <fca/formats/calibration.h>

#include <optional>

namespace fca {

/// Writes one file per camera of `rig`. The file is an edit of the input file that contains the camera if that file is of the
/// target's format, otherwise a fresh file. IMU files of the target's format are edited too. `source`: the calibration as read;
/// its cameras are those of `rig`, in the same order, before the conversion.
/// Returns nullopt without an error if no input file can be edited in this way: the format's files hold several cameras (except
/// plain-text files, if the extension is .txt), or no input file has a camera equal to one of `source`. Returns nullopt with
/// errors if a file cannot be written.
[[nodiscard]] std::optional<Written> write_each_into_its_own(const Calibration& source, const Rig& rig, const Format& format,
                                                             const WriteOptions& options, Diagnostics& diagnostics);

}  // namespace fca
