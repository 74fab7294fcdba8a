// SPDX-License-Identifier: BSD-3-Clause
// Proves written files with the readers of real programs, before anything is saved.
#pragma once

#include "loaded_views.h"

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>
#include <thread>

namespace fca {

/// Starts a thread that prepares the programs which read the format, e.g. loads OpenCV's libraries, which takes as long as a
/// fit. Nobody needs to wait for it: if it has not finished, or could not be started, a program prepares itself on first use.
[[nodiscard]] std::jthread prepare_programs(const Format& format);

/// The reason why a program would refuse the files written of `rig`, if it did not refuse `base` (null: none) for the same
/// reason; empty if there is no such program.
[[nodiscard]] Message newly_refused(const Written& written, const Rig& rig, const text::Document* base, LoadedViews& views);

/// Fixes spellings in the kept text of a base that the target's program would refuse (IMU.Frequency: 200, a byte order mark),
/// with a note about each. A file that the program would refuse anyway is not changed. True if nothing had to be fixed: the
/// programs load every file as it was.
[[nodiscard]] bool fix_kept_text(const Format& format, const Rig& rig, Written& written, LoadedViews& views,
                                 Diagnostics& diagnostics);

/// Adds a warning if the input's own program would not load it. The conversion continues, but the input may not be the file
/// which that program used.
void warn_if_refused(const Calibration& calibration, const Inputs& inputs, Diagnostics& diagnostics);

/// Proves one output file with its programs and adds the proofs and diagnostics to `result`. If the output is an edit of a file
/// that the program already refused, that is reported but not an error. An output that no program reads is reported too.
/// `base`: null if the output is not an edit.
void verify(const Rig& rig, const ConvertedFile& output, const ConvertRequest& request, const Written& written,
            const text::Document* base, LoadedViews& views, ConvertResult& result);

}  // namespace fca
